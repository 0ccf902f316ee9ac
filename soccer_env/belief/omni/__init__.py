"""Beliefs of middle-size robots: ball and players by filters, own pose by white lines, reports by radio.

    ball.py          The ball that a middle-size robot tracks: position and velocity.
    believe.py       The world model of a middle-size robot: ball, players, own pose, radio.
    field_lines.py   The own pose of a middle-size robot, by particles weighed by white lines and goals.
    kalman.py        Two filters for an object with constant velocity: a Kalman filter, and a forgetful line fit.
    lines.py         The white lines of a pitch: a robot's table of what it costs to see a line at a place.
    players.py       The other players that a middle-size robot tracks.
    radio.py         Reports by radio with own pose, ball and number; `reports.py` writes and uses them.
    reports.py       Use of team-mates' radio reports in a middle-size robot's belief.
    tracking.py      Tracking of an object over time: position and velocity (x, y, vx, vy).

`believe.py` calls them all, for one robot after the other.
"""
