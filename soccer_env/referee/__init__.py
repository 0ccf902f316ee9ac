"""The referee: goals, out of play, restarts, stuck ball, halves. One rule set per league, built from shared rules.

calls.py        what the referee sees and calls: goals, out of play, stuck ball, the end of a half
restart_call.py note a restart that is called
shoot_out.py    penalty kicks after a drawn match
restarts.py     how a restart is carried out: the ball, places, distances
formation.py    where robots stand at a restart
set_pieces.py   ... if its taker has to pass
steering.py     how robots drive there, round the held ball
places.py       the nearest free place for whoever has to move
areas.py        which robots stand in the areas before the goals
dropping.py     where a stuck ball is dropped
separation.py   robots that hold each other are pulled apart
fouls/          what is whistled, and what follows: penalties, free kicks, goals that do not count
"""
