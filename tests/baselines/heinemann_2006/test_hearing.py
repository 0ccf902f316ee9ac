"""What the referee box says is heard by radio, a while later; with the radio dead the team plays on."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.heinemann_2006.memory import ATTACKER, KEEPER, MEMORY, SCRATCH
from soccer_env.baselines.heinemann_2006.playing import hear
from soccer_env.records.beliefs import SITUATION
from soccer_env.types import Phase
from tests.baselines.heinemann_2006.test_goalkeeper import settings
from tests.scenes.staging import MIDDLE

STEP = 0.02  # [s]


def word(phase: Phase, ours: float, placing: int, clock: float) -> np.void:
    """Return a call of the referee box."""
    known = np.zeros(1, SITUATION)[0]
    known["phase"], known["ours"], known["placing"], known["phase_clock"] = int(phase), ours, placing, clock
    return known


def heard_of(words: list[np.void], delay: float) -> list[tuple[int, float, int, float]]:
    """Return what a player knows, a row for each step, of words that the box says in these steps."""
    memory, scratch = (np.zeros(1, dtype)[0] for dtype in (MEMORY, SCRATCH))
    told, rows = scratch["told"], []
    scratch["sight"]["elapsed"] = STEP
    for known in words:
        hear(known, told, memory, scratch["sight"], settings(word_delay=delay))
        rows.append(
            (int(told["phase"]), float(told["ours"]), int(told["placing"]), round(float(told["phase_clock"]), 6))
        )
    return rows


PLAYING = [word(Phase.PLAY, 0.0, 0, 7.0 + STEP * step) for step in range(20)]
THROWN_IN = [word(Phase.THROW_IN, -1.0, 1, STEP * step) for step in range(20)]


@pytest.mark.parametrize("steps", [0, 1, 3, 10])
def test_mh05_a_call_is_heard_after_the_radios_delay(steps: int) -> None:
    """What is known of whether, whose and which restart it is, and since when, is what was said a delay ago."""
    said = [(int(k["phase"]), k["ours"], int(k["placing"]), round(k["phase_clock"], 6)) for k in PLAYING + THROWN_IN]
    heard = heard_of(PLAYING + THROWN_IN, STEP * steps)
    assert heard[20:] == said[20 - steps : 40 - steps]


def test_mh05_a_call_that_takes_back_another_is_heard_no_sooner_for_it() -> None:
    over = [word(Phase.PLAY, 0.0, 0, STEP * step) for step in range(20)]
    heard = heard_of(PLAYING + THROWN_IN[:3] + over, 5 * STEP)
    assert {row[0] for row in heard} == {int(Phase.PLAY)}
    again = [word(Phase.THROW_IN, -1.0, 1, STEP * step) for step in range(20)]
    clocks = [row[3] for row in heard_of(THROWN_IN + again, 5 * STEP)]
    assert clocks[20:27] == pytest.approx([0.30, 0.32, 0.34, 0.36, 0.38, 0.00, 0.02])


def first_change(delay: float, ours: float) -> int:
    """Return in which step after a call the first robot does other than in the same match without the call."""
    match = Match(MIDDLE, home=5, away=5, matches=2, seeds=[7, 7], senses="sensors", placement="drive",
                  controllers={"home": f"heinemann-2006:word_delay={delay}", "away": "still"})  # fmt: skip
    match.matches["phase"] = int(Phase.PLAY)
    for step in range(200):
        if step == 100:
            match.matches["phase"][1], match.matches["restart_team"][1] = int(Phase.THROW_IN), ours
            match.matches["phase_clock"][1] = 0.0
        match.step()
        commands = match.robots["command"][:, :5]
        if commands[0].tobytes() != commands[1].tobytes():
            match.close()
            return step - 100
    raise AssertionError("nobody ever did anything about the call")


@pytest.mark.parametrize("ours", [0, 1])
def test_mh05_nobody_goes_to_a_place_for_a_restart_before_the_word_of_it_can_have_come(ours: int) -> None:
    at_once = first_change(0.0, ours)
    assert at_once <= 1
    for delay in (0.06, 0.5):
        assert first_change(delay, ours) >= at_once + round(delay / STEP)


def deaf(delay: float) -> Match:
    """Return matches in which no report arrives, and the referee box's words a delay [s] after they were said."""
    team = f"heinemann-2006:word_delay={delay}"
    return Match(MIDDLE, home=5, away=5, matches=4, seed=2, sensors={"radio_loss": 1.0}, placement="drive",
                 senses="sensors", controllers={"home": team, "away": team})  # fmt: skip


def test_mh05_with_the_radio_dead_for_half_a_minute_the_team_still_plays() -> None:
    match, attackers = deaf(0.06), []
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
        attackers += [(squad.memory["role"] == ATTACKER).sum(axis=1) for squad in match.squads]
        assert all((squad.memory["role"][:, 0] == KEEPER).all() for squad in match.squads)
    match.close()
    assert longest < 10.0 and (touched > 100).all()
    one, none = (np.array(attackers) == 1).mean(), (np.array(attackers) == 0).mean()
    assert one > 0.65 and none < 0.05  # who sees its mates agrees with them on who attacks


def test_mh05_whoever_hears_of_a_restart_ten_seconds_late_plays_all_the_same() -> None:
    match, touched = deaf(10.0), np.zeros(4)
    for _ in range(1500):
        match.step()
        touched += match.robot_events["touch"].any(axis=1)
    match.close()
    assert (touched > 10).all()
