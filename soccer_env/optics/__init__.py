"""The geometry of cameras, shared by sensors and beliefs: the direction or distance that a pixel shows.

    head_camera.py     a camera on a moving head: pixels, directions, and the place of the camera
    mirror_camera.py   the hyperbolic mirror: the distance on the ground that a pixel shows

perception/ draws the pictures, belief/ reads them.
"""
