"""`soccer watch`: show a live match or a replay in a window.

settings.py   its settings                           watching.py   the window, until it is closed
deck.py       the state that the keys set, and the shots, with rewind
"""
