"""What legged robots perceive: coloured blobs in the picture of the head camera, and an infrared range.

    blobs.py         From the pieces of a sketch to the blobs that the vision delivers: misses, merging, noise.
    bodies.py        The other robots in view of a camera: where they stand, and the boxes that hide things behind.
    calibration.py   Tables from sizes in the picture to ranges, made by rendering noiseless pictures.
    camera.py        The camera of a legged robot: where it is, where it looks, and what lies within its view.
    infrared.py      The infrared ranger on the camera's axis: it measures whatever its beam meets first.
    jersey.py        The jersey of a robot: coloured stickers on its trunk and head.
    occlusion.py     Occlusion: the visible parts of a thing behind bodies, column by column of the picture.
    outlines.py      Outlines of flat and boxy things in the picture: convex polygons.
    picture.py       The picture of the camera on a legged robot's head, down to the blobs that its vision delivers.
    scenery.py       What stands round the field: goals, landmarks, and patches in the ball's colour.
    sense.py         What all sensors of a legged robot deliver; ../body.py adds what every robot feels.
    sketch.py        The sketch of a picture: the place of each coloured thing, exact and without noise.
    solids.py        How far a ray travels before it meets something: a ball, a box, a post, the boards, the carpet.
    touch.py         The touch sensors of a legged robot: at head, chin, back and feet, and nowhere else.

How a picture is made: bodies, jersey and scenery -> sketch (outlines, occlusion) -> blobs; `sense.py` calls them all.
"""
