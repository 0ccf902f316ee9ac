"""The geometry of cameras, shared by sensors and beliefs: the direction or distance of a pixel.

    head_camera.py     a camera on a moving head: pixels, directions, and the place of the camera
    mirror_camera.py   the hyperbolic mirror: the distance on the ground that a pixel shows

The sensors of perception/ draw pictures with this geometry; belief/ reads the pictures.
"""
