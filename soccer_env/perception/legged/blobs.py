"""Turn the visible pieces of a sketch into the blobs that the vision reports, with misses, merging and noise.  MS04

Random numbers are drawn piece by piece in the order of the sketch, which is the same in a mirrored match and for both
teams. Only pieces in the picture cost a draw.

`s`: settings of the sensors.
"""

from math import floor

from soccer_env.compiled import compiled
from soccer_env.perception.legged.occlusion import PIECES
from soccer_env.perception.legged.sketch import BALL, OPPONENT_GOAL, OPPONENTS, OWN_GOAL, PATCHES, TEAMMATES
from soccer_env.random_numbers import draw_normal, draw_uniform
from soccer_env.records.percepts import BLOBS, LANDMARKS
from soccer_env.types import RobotStream

CAMERA_NOISE = int(RobotStream.CAMERA)
FALSE_BLOBS = int(RobotStream.FALSE_BLOBS)
SCALE_LEAST = 0.1  # [1] least scale of sizes, however large its error
SPOT = 0.5  # [1] width and height of an orange spot, as shares of its sticker's, assumed
EDGE = 1e-6  # [px] from the border at which a piece counts as cut off by it
TOUCHING = 0.5  # [px] gap below which two pieces are one blob, assumed


@compiled
def deliver_blobs(sketch, percept, state, noise, s):
    """Report the blobs of a sketch in a percept; the scale error of blob sizes is drawn once an episode.  MS04"""
    if state.scale == 0.0:
        state.scale = max(1.0 + s.scale_error * draw_normal(noise, CAMERA_NOISE), SCALE_LEAST)
    miss_pieces(sketch, BALL, noise, s.ball_miss)
    add_orange_spots(sketch, TEAMMATES, noise, s)
    add_orange_spots(sketch, OPPONENTS, noise, s)
    add_ball_coloured_patches(sketch)
    miss_players(sketch, noise, s)
    report_blobs(sketch, BALL, percept.ball, state.scale, noise, 0.0, s)
    report_blobs(sketch, TEAMMATES, percept.teammates, state.scale, noise, s.sticker_miss, s)
    report_blobs(sketch, OPPONENTS, percept.opponents, state.scale, noise, s.sticker_miss, s)
    report_blobs(sketch, OWN_GOAL, percept.own_goal, state.scale, noise, s.landmark_miss, s)
    report_blobs(sketch, OPPONENT_GOAL, percept.opponent_goal, state.scale, noise, s.landmark_miss, s)
    report_landmarks(sketch, percept.landmarks, state.scale, noise, s)


@compiled
def miss_pieces(sketch, kind, noise, probability):
    """Remove at random the pieces of one kind that the vision misses in this frame; one draw for each piece.  MS37"""
    kept, count = 0, sketch.counts[kind]
    for i in range(count):
        if draw_uniform(noise, CAMERA_NOISE) >= probability:
            if kept < i:
                sketch.pieces[kind, kept] = sketch.pieces[kind, i]
            kept += 1
    sketch.counts[kind] = kept


@compiled
def miss_players(sketch, noise, s):
    """Remove at random the stickers that the vision misses in this frame; one draw for each visible jersey.  MS37"""
    if s.player_miss <= 0.0:
        return
    kept_of_mates = kept_of_opponents = 0
    for i in range(sketch.body_count):
        body = sketch.bodies[i]
        if body.pieces == 0 or draw_uniform(noise, CAMERA_NOISE) < s.player_miss:
            continue
        kind, kept = (TEAMMATES, kept_of_mates) if body.teammate == 1 else (OPPONENTS, kept_of_opponents)
        for j in range(body.first, body.first + body.pieces):
            if kept < j:
                sketch.pieces[kind, kept] = sketch.pieces[kind, j]
            kept += 1
        if body.teammate == 1:
            kept_of_mates = kept
        else:
            kept_of_opponents = kept
    sketch.counts[TEAMMATES], sketch.counts[OPPONENTS] = kept_of_mates, kept_of_opponents


@compiled
def add_orange_spots(sketch, kind, noise, s):
    """Add orange spots on some stickers, which the vision may mistake for the ball in this frame.

    Both teams' stickers show spots, although only one team's stickers are red: otherwise the red team would be at a
    disadvantage, and swapping the teams would change a match.
    """
    for i in range(sketch.counts[kind]):
        if draw_uniform(noise, FALSE_BLOBS) >= s.red_as_orange or sketch.counts[BALL] >= PIECES:
            continue
        sticker, spot = sketch.pieces[kind, i], sketch.pieces[BALL, sketch.counts[BALL]]
        width, height = sticker.left - sticker.right, sticker.high - sticker.low
        spot.right = sticker.right + (1.0 - SPOT) * width * draw_uniform(noise, FALSE_BLOBS)
        spot.low = sticker.low + (1.0 - SPOT) * height * draw_uniform(noise, FALSE_BLOBS)
        spot.left, spot.high = spot.right + SPOT * width, spot.low + SPOT * height
        spot.area = SPOT * SPOT * sticker.area
        sketch.counts[BALL] += 1


@compiled
def add_ball_coloured_patches(sketch):
    """Add the ball-coloured patches beyond the boards to the pieces in the ball's colour."""
    for i in range(sketch.counts[PATCHES]):
        if sketch.counts[BALL] < PIECES:
            sketch.pieces[BALL, sketch.counts[BALL]] = sketch.pieces[PATCHES, i]
            sketch.counts[BALL] += 1


@compiled
def report_blobs(sketch, kind, blobs, scale, noise, missed, s):
    """Report the four largest blobs of a kind, largest first; each piece is missed with probability `missed`.  MS04

    [Sacks 2001, 2] Regions of any colour below the least area are dropped, as vision libraries do.  MS14
    """
    if sketch.counts[kind] == 0 and blobs[0].area == 0:
        return  # no pieces now, and no blobs left from the frame before
    if missed > 0.0:
        miss_pieces(sketch, kind, noise, missed)
    pieces, count = sketch.pieces[kind], sketch.counts[kind]
    if count > 1:
        count = merge_touching_pieces(pieces, count)
        put_largest_first(pieces, count, sketch.spare_piece)
    kept = 0
    for i in range(min(count, BLOBS)):
        measure_blob(sketch.camera, pieces[i], blobs[kept], scale, noise, s)
        if blobs[kept].area < sketch.camera.least_area:
            continue
        place = kept
        while place > 0 and blobs[place].area > blobs[place - 1].area:
            swap_records(blobs, place, place - 1, sketch.spare_blob)
            place -= 1
        kept += 1
    for i in range(kept, BLOBS):
        if blobs[i].area > 0:
            clear_blob(blobs[i])


@compiled
def report_landmarks(sketch, blobs, scale, noise, s):
    """Report the blob of each landmark; the left of a pair is drawn first, in a mirrored match the right."""
    for i in range(LANDMARKS):
        index = i if sketch.camera.handedness > 0.0 else i + 1 - 2 * (i % 2)
        if sketch.landmarks[index].area > 0.0 and draw_uniform(noise, CAMERA_NOISE) >= s.landmark_miss:
            measure_blob(sketch.camera, sketch.landmarks[index], blobs[index], scale, noise, s)
            if blobs[index].area < sketch.camera.least_area:
                clear_blob(blobs[index])
        elif blobs[index].area > 0:
            clear_blob(blobs[index])


@compiled
def merge_touching_pieces(pieces, count):
    """Merge pieces that touch or overlap, as a vision by colour does; return the number of pieces left."""
    i = 0
    while i < count:
        j = i + 1
        while j < count and not pieces_touch(pieces[i], pieces[j]):
            j += 1
        if j == count:
            i += 1
            continue
        one, other = pieces[i], pieces[j]
        one.left, one.right = max(one.left, other.left), min(one.right, other.right)
        one.high, one.low = max(one.high, other.high), min(one.low, other.low)
        one.area += other.area
        pieces[j] = pieces[count - 1]
        count -= 1
        i = 0  # the merged piece may touch others that its parts did not
    return count


@compiled
def pieces_touch(one, other):
    """Tell whether two pieces are so close that the vision sees them as one blob."""
    return (
        one.right < other.left + TOUCHING
        and other.right < one.left + TOUCHING
        and one.low < other.high + TOUCHING
        and other.low < one.high + TOUCHING
    )


@compiled
def put_largest_first(pieces, count, spare):
    """Move the four largest pieces to the front, largest first; equal pieces keep their order."""
    for place in range(min(count, BLOBS)):
        largest = place
        for i in range(place + 1, count):
            if pieces[i].area > pieces[largest].area:
                largest = i
        if largest > place:
            swap_records(pieces, place, largest, spare)


@compiled
def swap_records(things, one, other, spare):
    """Swap two records of an array by index; `spare` is a scratch record (1,)."""
    spare[0] = things[one]
    things[one] = things[other]
    things[other] = spare[0]


@compiled
def measure_blob(camera, piece, blob, scale, noise, s):
    """Measure a visible coloured piece as a blob: a box in whole pixels within the picture, with noise.

    Size and place vary at random by s.dither [px]; a piece that is cut off at an edge of the picture stays at the edge.
    """
    width, height = piece.left - piece.right, piece.high - piece.low
    columns = round_to_pixels(width * scale + s.dither * draw_normal(noise, CAMERA_NOISE), 2.0 * camera.half_width)
    rows = round_to_pixels(height * scale + s.dither * draw_normal(noise, CAMERA_NOISE), 2.0 * camera.half_height)
    u = 0.5 * (piece.left + piece.right) + s.dither * draw_normal(noise, CAMERA_NOISE)
    v = 0.5 * (piece.high + piece.low) + s.dither * draw_normal(noise, CAMERA_NOISE)
    left = blob_edge(u, columns, piece.left, piece.right, camera.half_width)
    high = blob_edge(v, rows, piece.high, piece.low, camera.half_height)
    blob.high, blob.low = int(high), int(high - rows)
    blob.area = int(max(floor(piece.area / (width * height) * columns * rows + 0.5), 1.0))
    if camera.handedness > 0.0:
        blob.left, blob.right = int(left), int(left - columns)
    else:
        blob.left, blob.right = int(columns - left), int(-left)


@compiled
def round_to_pixels(size, most):
    """Round a size to whole pixels, from 1 to the size of the picture."""
    return min(max(floor(size + 0.5), 1.0), most)


@compiled
def blob_edge(middle, count, high, low, border):
    """Return the edge of a blob of `count` pixels about `middle`, or the picture's border if the piece reaches it."""
    if high >= border - EDGE:
        return border
    if low <= EDGE - border:
        return count - border
    return max(min(floor(middle + 0.5 * count + 0.5), border), count - border)


@compiled
def clear_blob(blob):
    """Mark a blob as absent."""
    blob.left = blob.right = blob.high = blob.low = blob.area = 0
