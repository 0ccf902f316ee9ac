"""The referee: goals, out of play, restarts, stuck ball, halves. One rule set per league, built from shared rules.

calls.py        goals, out of play, stuck and dropped balls, the end of a half
restart_call.py note a restart that is called
shoot_out.py    penalty kicks after a drawn match
restarts.py     carry out a restart: the ball, places, distances
formation.py    places of the robots at a restart
set_pieces.py   places at a restart whose taker has to pass
steering.py     steer robots to their places, round the held ball
places.py       the nearest free place for each robot that has to move
areas.py        tell which robots stand in a goal area or penalty area
separation.py   pull apart robots that hold each other
fouls/          fouls and what follows: penalties, free kicks, annulled goals
"""
