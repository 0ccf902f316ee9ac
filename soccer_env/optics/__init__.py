"""The geometry of cameras, shared by sensors and beliefs: the direction or distance of a pixel.

    head_camera.py     The geometry of a camera on a moving head: pixels, directions, and the position of the camera.
    mirror_camera.py   The hyperbolic mirror: the distance on the ground of each pixel.

The sensors of perception/ draw pictures with this geometry; belief/ reads the pictures.
"""
