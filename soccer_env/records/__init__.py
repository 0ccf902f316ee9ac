"""Records of percepts, beliefs and the world, each field with its unit, frame and range, and the bytes of saves.

percepts.py    what sensors deliver                    beliefs.py     what robots believe
world.py       the arrays that a step passes about     ball_words.py  words of four bits for a distance to the ball
save_file.py   the bytes of a save, checked
"""
