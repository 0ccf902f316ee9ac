"""`soccer play`: a person plays one robot, or a whole team robot by robot, against any team.

settings.py   its settings                           playing.py   the match, its recording and the window
controls.py   keys and gamepad, and what they ask for
person.py     the robot that the person steers, and its actions
assists.py    what a robot does by itself while a key is held: carry the ball, shoot, pass
picture.py    the picture by the truth, and by the belief of the person's robot alone
"""
