"""What legged robots perceive: blobs in the picture of a camera on a moving head, and an infrared ranger.

    blobs.py         From the pieces of a sketch to the blobs that the vision delivers: misses, merging, noise ...
    bodies.py        The other robots before a camera: where they stand, and the boxes that hide what lies behind ...
    calibration.py   Tables from sizes in the picture to ranges, made by rendering noiseless pictures.
    camera.py        The camera of a legged robot: where it is, where it looks, and what lies within its view.
    infrared.py      The infrared ranger on the camera's axis: it measures whatever its beam meets first.
    jersey.py        The jersey of a robot: coloured stickers on its trunk and head.
    occlusion.py     Occlusion: what bodies leave of a thing that stands behind them, column by column of the picture.
    outlines.py      Outlines of flat and boxy things in the picture: convex polygons, an upper and a lower chain ...
    picture.py       The picture of the camera on a legged robot's head, down to the blobs that its vision delivers.
    scenery.py       What stands round the field of a legged robot: goals, landmarks, and patches that have the ...
    sense.py         What all sensors of a legged robot deliver; body and pose, every robot's, are felt in ../body.py.
    sketch.py        The sketch of a picture: where each coloured thing would be in it, in exact fractions of ...
    solids.py        How far a ray travels before it meets something: a ball, a box, a post, the boards, the carpet.
    touch.py         The touch sensors of a legged robot: at head, chin, back and feet, and nowhere else.

The way of a picture: bodies, jersey and scenery -> sketch (outlines, occlusion) -> blobs; `sense.py` calls them all.
"""
