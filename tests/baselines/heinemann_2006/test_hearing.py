"""What the referee box says is heard by radio, a while later; with the radio dead the team plays on."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.heinemann_2006.memory import MEMORY, SCRATCH
from soccer_env.baselines.heinemann_2006.playing import HEARD_LATE, hear
from soccer_env.belief_types import SITUATION
from soccer_env.types import Phase
from tests.baselines.heinemann_2006.test_goalkeeper import settings
from tests.scenes.staging import MIDDLE

STEP = 0.02  # [s]


@pytest.mark.parametrize("steps", [0, 3, 10])
def test_mh05_a_call_is_heard_after_the_radios_delay(steps: int) -> None:
    memory, scratch, known = (np.zeros(1, dtype)[0] for dtype in (MEMORY, SCRATCH, SITUATION))
    play, heard = settings(word_delay=STEP * steps + 0.005), []
    scratch["sight"]["elapsed"] = STEP
    known["phase"], memory["begun"] = int(Phase.PLAY), 1
    hear(known, scratch["told"], memory, scratch["sight"], play)
    known["phase"], known["ours"], known["placing"] = int(Phase.THROW_IN), -1.0, 1
    for step in range(14):
        known["phase_clock"] = STEP * step
        hear(known, scratch["told"], memory, scratch["sight"], play)
        told = scratch["told"]
        heard.append((int(told["phase"]), float(told["ours"]), int(told["placing"])))
    before, after = (int(Phase.PLAY), 0.0, 0), (int(Phase.THROW_IN), -1.0, 1)
    assert heard == [before] * steps + [after] * (14 - steps)
    assert told["phase_clock"] == pytest.approx(max(13 * STEP - play["word_delay"], 0.0))
    known["phase"] = int(Phase.PLAY)
    hear(known, scratch["told"], memory, scratch["sight"], settings(word_delay=1.0))
    assert told["phase"] == Phase.THROW_IN and told["phase_clock"] == HEARD_LATE


def test_mh05_with_the_radio_dead_for_half_a_minute_the_team_still_plays() -> None:
    match = Match(MIDDLE, home=5, away=5, matches=4, seed=2, sensors={"radio_loss": 1.0}, placement="drive",
                  senses="sensors", controllers={"home": "heinemann-2006", "away": "heinemann-2006"})  # fmt: skip
    still, longest, touched = np.zeros((4, 10)), 0.0, np.zeros(4)
    for _ in range(1500):
        match.step()
        field = (match.robots["keeper"] == 0) & (match.robots["active"] == 1)
        moves = np.hypot(match.robots["vx"], match.robots["vy"]) > 0.05
        plays = (match.matches["phase"] == Phase.PLAY)[:, None]
        near = np.hypot(match.robots["x"] - match.balls["x"][:, None], match.robots["y"] - match.balls["y"][:, None])
        idle = field & ~moves & plays & (near == near.min(axis=1, keepdims=True))
        still = np.where(idle, still + STEP, 0.0)
        longest = max(longest, float(still.max()))
        touched += match.robot_events["touch"].any(axis=1)
    match.close()
    assert longest < 10.0 and (touched > 10).all()
