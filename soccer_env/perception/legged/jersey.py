"""The jersey of a robot: coloured stickers on its trunk and head.  [Sacks 2001, 4.1.1, figure 4]  MS37, MS50

"Multiple stickers attached to given parts of their bodies": upright rectangles, s.trunk_stickers side by side on each
side of the trunk (chest, rump, two flanks), so that a missed or hidden sticker leaves others of the same height; and
one on each side of the head (brow, nape, two sides).

Seen at an angle stickers look narrower but no lower: "the width of a player differs depending on the angle at which it
is viewed, but its height remains constant" [Sacks 2001, 4.1.2]. The chest's stickers are a little smaller than the
flanks', which is why the robots "when viewed head-on appeared slightly smaller".

A head that is lower than s.head_down hides its own stickers, and, being black, the part of the trunk's stickers that
lies behind it: a near robot that looks at the ball seems far away.  [Sacks 2001, 4.3.3]

`s`: settings of the sensors.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import point_of_frame
from soccer_env.perception.legged.bodies import HEAD, TRUNK, in_box_axes


@compiled
def is_lowered(body, s):
    """Tell whether a robot's head is so low that it hides stickers of the jersey.  [Sacks 2001, 4.3.3]  MS50"""
    return body.tilt < -s.head_down


@compiled
def put_trunk_stickers(body, s, stickers):
    """List the trunk's stickers that face the camera, chest or rump first; return the number of stickers.  MS37"""
    trunk = body.boxes[TRUNK]
    middle = s.trunk_sticker_middle
    count = 0
    x, y = in_box_axes(trunk, 0.0, 0.0)
    if x > trunk.half_length:
        width, height = 0.5 * s.jersey * s.sticker_chest_width, 0.5 * s.jersey * s.sticker_chest_height
        for i in range(s.trunk_stickers):
            aside = sticker_offset(i, s.sticker_chest_apart, s)
            count = add_end_sticker(trunk, trunk.half_length, aside, middle, width, height, stickers, count)
    elif x < -trunk.half_length:
        width, height = 0.5 * s.jersey * s.sticker_rump_width, 0.5 * s.jersey * s.sticker_rump_height
        for i in range(s.trunk_stickers):
            aside = sticker_offset(i, s.sticker_rump_apart, s)
            count = add_end_sticker(trunk, -trunk.half_length, aside, middle, width, height, stickers, count)
    if abs(y) > trunk.half_width:
        width, height = 0.5 * s.jersey * s.sticker_flank_width, 0.5 * s.jersey * s.sticker_flank_height
        side = trunk.half_width if y > 0.0 else -trunk.half_width
        for i in range(s.trunk_stickers):
            ahead = sticker_offset(i, s.sticker_flank_apart, s)
            count = add_side_sticker(trunk, ahead, side, middle, width, height, stickers, count)
    return count


@compiled
def sticker_offset(i, apart, s):
    """Return the distance [m] of sticker i from the middle of its face; neighbours are `apart` [m].  MS37"""
    return apart * (i - 0.5 * (s.trunk_stickers - 1))


@compiled
def put_head_stickers(body, s, stickers):
    """List the head's stickers that face the camera, brow or nape first; return the number of stickers.  MS37"""
    head, count = body.boxes[HEAD], 0
    width, height = 0.5 * s.jersey * s.sticker_head_width, 0.5 * s.jersey * s.sticker_head_height
    x, y = in_box_axes(head, 0.0, 0.0)
    if abs(x) > head.half_length:
        face = head.half_length if x > 0.0 else -head.half_length
        count = add_end_sticker(head, face, 0.0, body.crown, width, height, stickers, count)
    if abs(y) > head.half_width:
        side = head.half_width if y > 0.0 else -head.half_width
        count = add_side_sticker(head, body.crown_ahead, side, body.crown, width, height, stickers, count)
    return count


@compiled
def add_end_sticker(box, x, y, middle, half_width, half_height, stickers, count):
    """Append a sticker on the front or back face of a box; return the new number of stickers."""
    sticker = stickers[count]
    sticker.ahead, sticker.left = point_of_frame(box.ahead, box.left, x, y, box.cosine, box.sine)
    sticker.across, sticker.aside = -box.sine * half_width, box.cosine * half_width
    sticker.low, sticker.high = middle - half_height, middle + half_height
    return count + 1


@compiled
def add_side_sticker(box, x, y, middle, half_width, half_height, stickers, count):
    """Append a sticker on a side face of a box; return the new number of stickers."""
    sticker = stickers[count]
    sticker.ahead, sticker.left = point_of_frame(box.ahead, box.left, x, y, box.cosine, box.sine)
    sticker.across, sticker.aside = box.cosine * half_width, box.sine * half_width
    sticker.low, sticker.high = middle - half_height, middle + half_height
    return count + 1
