"""What middle-size robots believe: ball and players by filters, own pose by lines, reports by radio.

    ball.py          The ball that a middle-size robot tracks: where it is, where it goes.
    believe.py       The world model of a middle-size robot: ball, players, own pose, radio.
    field_lines.py   How well poses fit the white lines and goals that a middle-size robot sees.
    kalman.py        Two ways to follow a thing that moves evenly: a Kalman filter, and a line fit that forgets.
    own_pose.py      The own pose of a middle-size robot: its particles go by white lines and goals.
    players.py       The players that a middle-size robot tracks.
    radio.py         Reports by radio: own pose, ball and number; `reports.py` makes and uses them.
    reports.py       What a middle-size robot makes of its team-mates' reports.
    tracking.py      One thing tracked over time: place and speed (x, y, vx, vy).

`believe.py` calls them all, for one robot after the other.
"""
