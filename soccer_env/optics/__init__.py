"""What a camera and the robot that reads its pictures share: which pixel shows which direction or distance.

    head_camera.py     Geometry of a camera on a moving head: pixels, directions, and where the camera stands.
    mirror_camera.py   The hyperbolic mirror: which pixel shows which distance on the ground.

Neither knows what stands in the picture: that is perception/'s, and what it means is belief/'s.
"""
