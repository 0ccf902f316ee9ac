"""Beliefs of middle-size robots: ball and players by filters, own pose by white lines, reports by radio.

    ball.py          The ball that a middle-size robot tracks: place and velocity.
    believe.py       The world model of a middle-size robot: ball, players, own pose, radio.
    field_lines.py   The own pose of a middle-size robot: particles weighed by the white lines and goals that it sees.
    kalman.py        Two ways to follow a thing that moves evenly: a Kalman filter, and a line fit that forgets.
    players.py       The players that a middle-size robot tracks.
    radio.py         Reports by radio: own pose, ball and number; `reports.py` makes and uses them.
    reports.py       How a middle-size robot uses its team-mates' reports.
    tracking.py      One thing tracked over time: place and speed (x, y, vx, vy).

`believe.py` calls them all, for one robot after the other.
"""
