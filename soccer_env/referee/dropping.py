"""Where a stuck ball is dropped: near where it stuck, where robots reach it from all sides, and no nearer to a goal.

* A ball at a board is taken straight out from it, until a robot has room to stand between the two, by the rules'
  `drop_way` at most; in a corner, out from both boards. What play has won or lost on the pitch stays so.
* A ball before a goal is dropped on the line of the area there that runs along the goal line, where the ball was. The
  laws of football have it so for the goal area (Law 8, remembered); the legged league has a penalty area alone, and
  its book of 2008 puts a ball that is stuck with a goalkeeper on the centre spot. Nobody gets a free shot from nearer,
  and nobody loses the pitch that he has won.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import length


@compiled
def drop_place(ball, k):
    """Return where a ball that is stuck is dropped [m, m, field frame]."""
    side_x, side_y = 1.0 if ball.x > 0.0 else -1.0, 1.0 if ball.y > 0.0 else -1.0
    depth, width = k.pitch_goal_area_depth, k.pitch_goal_area_width
    if depth <= 0.0:
        depth, width = k.pitch_penalty_depth, k.pitch_penalty_width
    line = 0.5 * k.pitch_length - depth
    if abs(ball.x) > line and abs(ball.y) < 0.5 * width:
        return side_x * line, ball.y
    room = 2.0 * k.body_reach + k.ball_radius
    x = max(abs(ball.x) - 0.5 * k.pitch_length + room, 0.0)
    y = max(abs(ball.y) - 0.5 * k.pitch_width + room, 0.0)
    way = length(x, y)
    share = min(k.rules_drop_way / way, 1.0) if way > 0.0 else 0.0
    return ball.x - side_x * share * x, ball.y - side_y * share * y
