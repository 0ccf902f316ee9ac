"""`soccer watch`: a match that is played, or a replay, in a window.

settings.py   its settings             tape.py       shots that can be gone back to
deck.py       what the keys have set   watching.py   the window, until it is closed
"""
