"""Balls that roll past a player, and passes: with each base, after each kick, with each cycle.  [H. 2006, 1, 2]"""

from functools import partial
from typing import Any

import numpy as np

from soccer_env.baselines.heinemann_2006.settings import HeinemannSettings
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.match import Match
from soccer_env.skills.set_pieces import kick_strength_for
from soccer_env.teams import make_team
from soccer_env.train.papers import staging
from soccer_env.train.papers.claim import FIRST, Batch, claim, compare
from soccer_env.train.papers.claims.goalkeeping.shots import SHOT_TEXT, SHOTS, face_shots
from soccer_env.train.papers.plots import each, plot, plot_bins
from soccer_env.train.papers.staging import MIDDLE
from soccer_env.train.papers.values import gain, mean
from soccer_env.train.papers.verdicts import Samples, measured, reported

BALLS = 48  # of a batch
SECONDS = 6.0  # [s] to receive a ball
HAD = 0.3  # [s] that a received ball lies at the kicker
LOOK = 0.5  # [s] of looking at the ball before it moves
FROM = (3.0, 5.0)  # [m] of the ball from the player
ASIDE = (0.0, 1.5)  # [m] of the ball's way beside the player, to either side
SPEEDS = (1.0, 3.0)  # [m/s] of the rolling ball at its start
OLD = "middle-size-2006-differential"
WAYS: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {  # settings of the team, of the memory: H24
    "with": ({}, {}), "without": ({}, {"filter": "none"}), "follows": ({"intercepts": False}, {}),
}  # fmt: skip
BALL_TEXT = (
    f"{BALLS} balls a batch that roll at {SPEEDS[0]:g} to {SPEEDS[1]:g} m/s from {FROM[0]:g} to {FROM[1]:g} m away "
    f"past a player that faces them, up to {ASIDE[1]:g} m aside, by sensors and particles; it gets a ball if that lies "
    f"at its kicker for {HAD:g} s within {SECONDS:g} s, while the ball is on the pitch"
)


def receive(batch: Batch, settings: dict[str, Any], league: str = MIDDLE, **more: Any) -> Samples:
    """Roll balls past a field player of heinemann-2006; return which it gets (M,), times [s] and ball speeds [m/s]."""
    rng = batch.rng()
    match = staging.stage_team(batch, "heinemann-2006", settings, league, matches=BALLS, home=2, **more)
    x, y = rng.uniform(-2.0, 1.0, BALLS), rng.uniform(-1.5, 1.5, BALLS)
    from_, away = rng.uniform(-np.pi, np.pi, BALLS), rng.uniform(*FROM, BALLS)
    aside, speed = rng.choice([-1.0, 1.0], BALLS) * rng.uniform(*ASIDE, BALLS), rng.uniform(*SPEEDS, BALLS)
    staging.put(match, 1, x, y, from_)
    ball_x = np.clip(x + away * np.cos(from_), -5.5, 5.5)
    ball_y = np.clip(y + away * np.sin(from_), -3.6, 3.6)
    course = np.arctan2(y - ball_y, x - ball_x) + np.arctan2(aside, away)
    staging.put_ball(match, ball_x, ball_y)
    staging.begin_scene(match, placed=True)
    for _ in range(round(LOOK * match.league.control_rate)):
        staging.put(match, 1, x, y, from_)
        staging.put_ball(match, ball_x, ball_y)
        match.rebuild()
        match.step()
    staging.put(match, 1, x, y, from_)
    staging.put_ball(match, ball_x, ball_y, speed * np.cos(course), speed * np.sin(course))
    match.rebuild()
    return wait_for_possession(match, 1) | {"speed": speed}


def wait_for_possession(match: Match, r: int, actions: np.ndarray | None = None) -> Samples:
    """Play until robot `r` has had the ball for HAD seconds; return in which matches it has (M,), and the times [s]."""
    league, pitch = match.league, match.league.pitch
    held, got, time = np.zeros(match.count), np.zeros(match.count, bool), np.full(match.count, SECONDS)
    open_ = np.ones(match.count, bool)
    for step in range(round(SECONDS * league.control_rate)):
        match.step(actions)
        held = np.where(match.robots["has_ball"][:, r] == 1, held + league.dt, 0.0)
        now = open_ & (held > HAD)
        got |= now
        time[now] = step * league.dt
        on = (np.abs(match.balls["x"]) < pitch.length / 2) & (np.abs(match.balls["y"]) < pitch.width / 2)
        open_ &= ~got & on
        if not open_.any():
            break
    match.close()
    return {"got": got.astype(float), "time": time}


H24 = claim(
    "H24", "1", "A pass receiver uses the ball's velocity to intercept it.",
    f"{BALL_TEXT}; with the ball's velocity, and with none in its belief (filter=none), all else the same.",
    measured("more balls are had, of 100", gain, "with got", "without got", above=5.0),
    reported("with it, going to where the ball is (intercepts=False)", "follows got", unit="%"),
    measure=lambda batch: compare(WAYS, lambda how: receive(batch, how[0], memory=how[1]), FIRST),
    figures=plot_bins("Passes received", "speed of the ball [m/s]", "received [%]",
                      {"with the ball's velocity": "with got", "without": "without got"}, "with speed",
                      (1.0, 1.5, 2.0, 2.5, 3.0), mean, place_scale=1.0),
    batches=6, seconds=5.0,
)  # fmt: skip


def compare_bases(batch: Batch) -> Samples:
    """Return the results of `receive` and goals from far-post shots, with the fast base and with the old base."""

    def results(league: str) -> Samples:
        return {**receive(batch, {}, league), "goal": face_shots(batch, {}, league=league).goal.astype(float)}

    return compare({"fast": MIDDLE, "old": OLD}, results, FIRST)


H01 = claim(
    "H01", "1, 2", "Omnidirectional robots of 2.6 m/s replaced Pioneers of 1.6 m/s to stay competitive.",
    f"{BALL_TEXT}; and {SHOTS} {SHOT_TEXT}. The same team on both bases.",
    measured("more balls are had, of 100", gain, "fast got", "old got", above=5.0),
    measured("fewer goals by far-post shots, of 100", lambda s: 100 * mean(s["old goal"] - s["fast goal"]), above=5.0),
    measure=compare_bases, batches=4, seconds=9.0,
    note="The old base turns in place and cannot step aside: both differ, as they did.",
)  # fmt: skip

FAR = (2.5, 4.5)  # [m] of a pass


def kick_passes(batch: Batch, controlled: bool) -> Samples:
    """Let a robot kick a pass to a mate; return the ball's top speed [m/s] and the passes (M,) that the mate gets."""
    rng, league = batch.rng(), find_league(MIDDLE)
    k = constants_of(league)[0]
    match = staging.stage(batch, MIDDLE, matches=BALLS, home=3, controllers={"home_2": make_team("heinemann-2006")})
    far, way = rng.uniform(*FAR, BALLS), rng.uniform(-np.pi, np.pi, BALLS)
    x, y = -0.5 * far * np.cos(way), -0.5 * far * np.sin(way)
    staging.put(match, 1, x, y, way)
    staging.put(match, 2, -x, -y, way + np.pi)
    staging.put_ball(match, *staging.point_ahead(match, 1, league.body.front + league.ball.radius + 0.003, 0.0))
    staging.begin_scene(match, placed=True)
    actions = staging.still_actions(match)
    arrival = HeinemannSettings().pass_arrival
    kick = np.array([kick_strength_for(k, one, arrival) for one in far]) if controlled else np.ones(BALLS)
    actions[:, 1, 3] = kick
    top = np.zeros(BALLS)
    for _ in range(2):  # a kick needs a ball that was noticed at the kicker in the step before
        match.step(actions)
        top = np.maximum(top, np.hypot(match.balls["vx"], match.balls["vy"]))
    return wait_for_possession(match, 2, staging.still_actions(match)) | {"top": top}


H03 = claim(
    "H03", "2", "The kicker reaches 10 m/s, and its strength can be controlled for passes.",
    f"{BALLS} passes a batch over {FAR[0]:g} to {FAR[1]:g} m to a mate that faces the kicker, with the strength "
    f"after which the ball arrives at {HeinemannSettings().pass_arrival:g} m/s, and with all of it; had as in H24.",
    measured("more passes are had, of 100", gain, "soft got", "full got", above=20.0),
    measured("controlled passes had", "soft got", unit="%", above=50.0),
    measure=lambda batch: compare({"soft": True, "full": False}, partial(kick_passes, batch), FIRST),
    batches=4, seconds=5.0,
    ingredients=("the kicker's 0 to 10 m/s and the scatter of 5 % and 2 degrees of a kick",),
)  # fmt: skip

# The length of a decision cycle

CYCLES = (0.02, 0.04, 0.1)  # [s]


def compare_cycles(batch: Batch) -> Samples:
    """Return which shots are saved and which rolling balls are received (M,), for each length of the decision cycle."""
    samples: Samples = {}
    for cycle in CYCLES:
        samples[f"saved {cycle:g}"] = 1.0 - face_shots(batch, {"cycle": cycle}).goal.astype(float)
        samples[f"had {cycle:g}"] = receive(batch, {"cycle": cycle})["got"]
    return samples


H28 = claim(
    "H28", "2", "A cycle of 20 ms makes the robot extremely reactive.",
    f"{SHOTS} {SHOT_TEXT}; {BALL_TEXT}. Decisions every 20, 40 and 100 ms, the camera and the delay as they are.",
    measured("more saves at 20 than at 100 ms, of 100", gain, "saved 0.02", "saved 0.1", above=0.0),
    measured("more balls had at 20 than at 100 ms, of 100", gain, "had 0.02", "had 0.1", above=0.0),
    measured("saves at 40 ms above 100 ms, of 100", gain, "saved 0.04", "saved 0.1", at_least=-5.0),
    measured("saves at 20 ms above 40 ms, of 100", gain, "saved 0.02", "saved 0.04", at_least=-5.0),
    measure=compare_cycles,
    figures=plot("What a shorter cycle is worth", "cycle [ms]", "share [%]", [1000.0 * cycle for cycle in CYCLES],
                 {text: each(CYCLES, lambda s, name, cycle: 100.0 * mean(s[f"{name} {cycle:g}"]), name)
                  for name, text in {"saved": "far-post shots saved", "had": "rolling balls had"}.items()}),
    batches=4, seconds=12.0,
    ingredients=("camera and delay stay at 50 Hz and 0.1 s: only decisions are rarer",),
)  # fmt: skip
