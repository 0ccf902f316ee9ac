"""The kinds of robots, each declared in one file; the code for a kind is in folders named after the kind.

    legged.py   camera on a moving head, infrared ranger: perception/legged, belief/legged, leagues/legged_sensors.py
    omni.py     omnidirectional camera: perception/omni, belief/omni, leagues/omni_sensors.py

`leagues/robot_kind.py` declares the fields of a kind and finds the kinds.
"""
