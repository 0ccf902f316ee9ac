"""What legged robots perceive: coloured blobs in the picture of the head camera, and an infrared range.

    blobs.py         Turn the visible pieces of a sketch into blobs, with misses, merging and noise.
    bodies.py        The other robots in view of a camera: their places, and the boxes that hide things.
    calibration.py   Calibration tables from sizes in the picture to ranges, computed from noiseless pictures.
    camera.py        The camera of a legged robot: its position, its direction, and a test whether things are in view.
    infrared.py      The infrared ranger on the camera's axis measures the distance to the first thing.
    jersey.py        The jersey of a robot: coloured stickers on its trunk and head.
    occlusion.py     Occlusion: find the visible parts of a thing behind other robots.
    outlines.py      Outlines of panels and boxes in the picture: convex polygons.
    picture.py       The picture of a legged robot's head camera, up to the blobs that its vision reports.
    scenery.py       The surroundings of the field: goals, landmarks, and ball-coloured patches.
    sense.py         All sensors of a legged robot: camera, infrared ranger, touch, own body.
    sketch.py        The sketch of a picture: the position of each coloured thing, without noise.
    solids.py        Ray casting: the distance along a ray to a ball, a box, a post, the boards or the carpet.
    touch.py         The touch sensors of a legged robot: at head, chin, back and feet only.

How a picture is made: bodies, jersey and scenery -> sketch (outlines, occlusion) -> blobs; `sense.py` calls them all.
"""
