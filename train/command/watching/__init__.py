"""`soccer watch`: show a live match or a replay in a window.

settings.py   its settings                           tape.py       the shots, with rewind
deck.py       the state that the keys set            watching.py   the window, until it is closed
"""
