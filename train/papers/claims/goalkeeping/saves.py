"""Saves of the passive and the active goalkeeper, of shots at the farther post.  [Heinemann et al. 2006, 4]"""

from collections.abc import Sequence
from functools import partial
from math import inf
from typing import Any

from soccer_env.train.papers.claim import Batch, claim, shared
from soccer_env.train.papers.claims.goalkeeping.shots import FEWER, SHOT_TEXT, SHOTS, SLOWER, SPEEDS, face_shots
from soccer_env.train.papers.plots import each, plot, plot_bins, plot_curves, plots
from soccer_env.train.papers.values import mean, ratio
from soccer_env.train.papers.verdicts import Samples, measured, reported

FIT = {"filter": "least-squares", "window": 5.0}  # a tracker of kicked balls: a line fit over five frames
KEEPERS: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {  # settings of the team, of the memory
    "passive": ({"keeper": "passive"}, FIT),
    "active": ({}, FIT),
    "kalman": ({}, {}),  # active, with the team's own filter
}
RADII = (0.5, 0.7, 0.9, 1.2)  # [m] of half circles about the middle of the goal; the team's is 1.2, which was chosen
LINE = {"stance": "line"}
STANCES: dict[str, dict[str, Any]] = {"line": LINE} | {f"{radius:g}": {"keeper_radius": radius} for radius in RADII}
BINS = (4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0)  # [m/s] edges of the speed at the kick
STANCE_TEXT = (
    f"{SHOTS} {SHOT_TEXT}: the farther post, the same shots at a passive and an active keeper. Typical keepers moved "
    '"on the goal line or on a half circle": the goal line decides, and a curve shows half circles of '
    f"{RADII[0]:g} to {RADII[-1]:g} m. Velocities by a fit over five frames, beside it by the team's Kalman filter"
)
NOTE = (
    "The paper tells neither radius nor tracker. On a half circle of a metre and more a keeper covers most of the goal "
    "by standing there. The team's own filter is tuned to all balls of play (leagues/omni_sensors.py); a kick is more "
    "than it expects."
)
INGREDIENTS = ("a reaction of 0.1 s and 4 m/s2: the league's delay and base", "the tracker: see H29")


@shared("stances")
def compare_stances(batch: Batch) -> Samples:
    """Return the goals and keepers' ways [m] (M,) of equal shots, for each of STANCES and KEEPERS, and their speeds.

    "near ...": goals of shots at the nearer post, keepers on the line.
    """
    samples: Samples = {}
    for keeper, (settings, memory) in KEEPERS.items():
        for stance, place in STANCES.items():
            faced = face_shots(batch, settings | place, memory=memory)
            samples |= {"speed": faced.speed, f"{stance} {keeper}": faced.goal.astype(float)}
            samples[f"{stance} {keeper} way"] = faced.moved
        near = face_shots(batch, settings | LINE, memory=memory, near_post=True)
        samples[f"near {keeper}"] = near.goal.astype(float)
    return samples


def conceded_share(samples: Samples, name: str, fastest: float = inf) -> float:
    """Return the share of goals [%] among the shots of at most `fastest` [m/s]."""
    return 100.0 * mean(samples[name][samples["speed"] <= fastest])


def saved_share(samples: Samples, name: str, fastest: float = inf) -> float:
    """Return the share of saves [%] among the shots of at most `fastest` [m/s]."""
    return 100.0 - conceded_share(samples, name, fastest)


def conceded_ratio(samples: Samples, stance: str, fastest: float = inf) -> float:
    """Return the active keeper's share of goals over the passive keeper's; 1 if the passive keeper concedes none."""
    passive = conceded_share(samples, f"{stance} passive", fastest)
    return conceded_share(samples, f"{stance} active", fastest) / passive if passive > 0.0 else 1.0


TITLES = {"passive": "passive", "active": "active, fit", "kalman": "active, Kalman filter"}
stance_figures = plots(
    plot(
        "Goals of shots at the farther post", "radius of the half circle [m], 0: goal line", "goals [%]", (0.0, *RADII),
        {title: each(STANCES, lambda s, keeper, stance: conceded_share(s, f"{stance} {keeper}"), keeper)
         for keeper, title in TITLES.items()}, rules=(50.0,), rule="half of them",
    ),
    plot_bins(
        "Goals on the goal line", "speed at the kick [m/s]", "goals [%]",
        {f"{title}, far post": f"line {keeper}" for keeper, title in TITLES.items()}, "speed", BINS, mean,
        place_scale=1.0, rules=(50.0,), rule="half of them",
    ),
)  # fmt: skip


H18 = claim(
    "H18", "4", "On the line d, with its delay, a goalkeeper concedes most shots at the farther post.",
    f"{STANCE_TEXT}.",
    measured("goals, passive keeper on the goal line", "line passive", unit="%", at_least=50.0),
    measure=compare_stances, condition="on the goal line", figures=stance_figures, batches=4, seconds=4.0,
    ingredients=INGREDIENTS,
    note=f"{NOTE} A kicked ball slides first and rolls on at 0.6 of its speed; shots in the paper's words are not.",
)  # fmt: skip

H19 = claim(
    "H19", "4", "Even with its delay the active goalkeeper has a high chance to intercept the ball.",
    f"{STANCE_TEXT}.",
    measured(f"shots saved, {SPEEDS[0]:g} to {SPEEDS[1]:g} m/s, goal line", saved_share, "line active", unit="%",
             at_least=80.0),
    reported("at the nearer post", saved_share, "near active", unit="%"),
    measure=compare_stances, condition="on the goal line, with a fit over five frames", figures=stance_figures,
    batches=8, seconds=4.0,
    ingredients=INGREDIENTS,
    note=NOTE,
)  # fmt: skip

H20 = claim(
    "H20", "4", "Moving into the predicted trajectory drastically reduces goals by shots at the farther post.",
    f"{STANCE_TEXT}.",
    measured("active keeper's goals over the passive one's, goal line", conceded_ratio, "line", at_most=0.5),
    measured(f"the same up to {SLOWER:g} m/s", conceded_ratio, "line", SLOWER, at_most=0.2),
    measure=compare_stances, condition="on the goal line, with a fit over five frames", figures=stance_figures,
    batches=6, seconds=4.0,
    ingredients=INGREDIENTS,
    note=NOTE,
)  # fmt: skip

H23 = claim(
    "H23", "4", "The passive goalkeeper is too static until the ball is passing it.",
    f"{STANCE_TEXT}; how far the keeper moves before the ball is level with it.",
    measured("active keeper's way over the passive one's, until level (means)", ratio, "line active way",
             "line passive way", above=2.0),
    measure=compare_stances, condition="on the goal line", figures=stance_figures, batches=6, seconds=4.0,
    ingredients=INGREDIENTS,
    note=NOTE,
)  # fmt: skip

H30 = claim(
    "H30", "4", "Many goalkeepers have a fairly good defensive behaviour on the goal line or a half circle.",
    f'{STANCE_TEXT}; passive keepers\' saves. The paper gives no measure of "fairly good".',
    reported("saved at the nearer post, goal line", saved_share, "near passive", unit="%"),
    reported("saved at the farther post, goal line", saved_share, "line passive", unit="%"),
    measure=compare_stances, figures=stance_figures, batches=2, seconds=4.0,
    ingredients=INGREDIENTS,
)  # fmt: skip

NOISES = {"own": 0.7, "tenfold": 7.0, "thirtyfold": 21.0}  # [px] sd of a blob's place in the image
FITS: dict[str, dict[str, Any]] = {"kalman": {}, "fit": FIT}
TRIED = (("fit", "own"), ("fit", "tenfold"), ("fit", "thirtyfold"), ("kalman", "own"), ("kalman", "thirtyfold"))


def compare_camera_noise(batch: Batch) -> Samples:
    """Return goals (M,) against both keepers by camera noise, with a fit over five frames or a Kalman filter."""
    samples: Samples = {}
    for fit, noise in TRIED:
        more: dict[str, Any] = {"sensors": {"pixel_noise": NOISES[noise]}, "memory": FITS[fit], "shots": FEWER}
        faced = {name: face_shots(batch, KEEPERS[name][0] | LINE, **more) for name in ("passive", "active")}
        samples |= {f"{fit} {noise} {name}": one.goal.astype(float) for name, one in faced.items()}
        samples[f"{fit} {noise} error"] = faced["active"].error
    return samples


def prevented_goals(samples: Samples, fit: str, noise: str) -> float:
    """Return how many goals in a hundred shots the active keeper prevents, compared with the passive keeper."""
    return 100.0 * mean(samples[f"{fit} {noise} passive"] - samples[f"{fit} {noise} active"])


def goals_by_error(samples: Samples, fit: str) -> Sequence[Sequence[float]]:
    """Return the error of the believed ball [cm] and the prevented goals, for each noise tried with a filter."""
    noises = [noise for tried, noise in TRIED if tried == fit]
    errors = [100.0 * mean(samples[f"{fit} {noise} error"]) for noise in noises]
    return errors, [prevented_goals(samples, fit, noise) for noise in noises]


H22 = claim(
    "H22", "4", "The active goalkeeper needs the ball's velocity from good tracking.",
    f"{FEWER} {SHOT_TEXT}: the farther post, both keepers on the goal line, blobs displaced by a noise of 0.7 "
    "px (the sensor's own) to 21 px, velocities by the Kalman filter and by a fit over five frames.",
    measured("goals spared at the sensor's own noise", prevented_goals, "fit", "own", unit="%", above=10.0),
    measured("goals spared at 30 times the noise, fit over five frames", prevented_goals, "fit", "thirtyfold",
             unit="%", at_most=5.0),
    measure=compare_camera_noise, condition="with a fit over five frames", batches=5, seconds=10.5,
    figures=plot_curves("What the active keeper spares", "error of the believed ball [cm]", "goals [%]",
                        {text: partial(goals_by_error, fit=fit)
                         for fit, text in (("kalman", "Kalman filter"), ("fit", "fit over five frames"))}),
    ingredients=INGREDIENTS,
)  # fmt: skip
