"""The kinds of robots, each declared in one file; its code lies in folders of the same name.

    legged.py   camera on a moving head, infrared ranger: perception/legged, belief/legged, leagues/legged_sensors.py
    omni.py     omnidirectional camera: perception/omni, belief/omni, leagues/omni_sensors.py

`leagues/robot_kind.py` says what a kind is and where each is found.
"""
