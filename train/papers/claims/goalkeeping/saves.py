"""Saves of the passive and the active goalkeeper, of shots at the farther post.  [Heinemann et al. 2006, 4]"""

from collections.abc import Sequence
from math import inf
from typing import Any

from soccer_env.train.papers.claim import Batch, Claim, Curve, Figure, curves_by_bin
from soccer_env.train.papers.claims.goalkeeping.shots import FEWER, SHOT_TEXT, SHOTS, SLOWER, SPEEDS, face_shots
from soccer_env.train.papers.values import mean
from soccer_env.train.papers.verdicts import Samples, measured, reported

KEEPERS: dict[str, dict[str, Any]] = {"passive": {"keeper": "passive"}, "active": {}}
LINES: dict[str, dict[str, Any]] = {"nearer": {"keeper_radius": 0.8}, "line": {"stance": "line"}}  # 0.8 m: Tribots 2005
BINS = (4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0)  # [m/s] edges of the speed at the kick
CHOSEN = (
    "The radius of the keeper's half circle, 1.2 m, was chosen on shots like these: 0.7 m let in more, of both keepers."
)
INGREDIENTS = (
    "a reaction of 0.1 s and 4 m/s2: the league's delay and base",
    "radius of the keeper's half circle, chosen on shots like these",
)


def compare_saves(batch: Batch, **more: Any) -> Samples:
    """Return goals (M,) of far-post shots at both keepers, the keepers' distances moved [m], and the shots' speeds."""
    samples: Samples = {}
    for name, settings in KEEPERS.items():
        faced = face_shots(batch, settings, **more)
        samples |= {"speed": faced.speed, name: faced.goal.astype(float), f"{name} way": faced.moved}
    return samples


def compare_posts(batch: Batch) -> Samples:
    """Return samples of `compare_saves`, and goals of near-post shots and against passive keepers on the goal line."""
    near = {f"near {name}": face_shots(batch, settings, near_post=True).goal.astype(float)
            for name, settings in KEEPERS.items()}  # fmt: skip
    line = face_shots(batch, {"keeper": "passive", "stance": "line"}).goal.astype(float)
    return compare_saves(batch) | near | {"line": line}


def compare_keeper_lines(batch: Batch) -> Samples:
    """Return samples of `compare_saves`, and goals against keepers on a half circle of 0.8 m and on the goal line."""
    samples = compare_saves(batch)
    for line, stance in LINES.items():
        for name, settings in KEEPERS.items():
            samples[f"{line} {name}"] = face_shots(batch, settings | stance).goal.astype(float)
    return samples


def conceded_share(samples: Samples, name: str, fastest: float = inf) -> float:
    """Return the share of goals [%] among the shots of at most `fastest` [m/s]."""
    return 100.0 * mean(samples[name][samples["speed"] <= fastest])


def conceded_ratio(samples: Samples, fastest: float = inf) -> float:
    """Return the active keeper's share of goals over the passive keeper's; 1 if the passive keeper concedes none."""
    passive = conceded_share(samples, "passive", fastest)
    return conceded_share(samples, "active", fastest) / passive if passive > 0.0 else 1.0


def goals_by_speed_figure(samples: Samples) -> Sequence[Figure]:
    """Plot the share of goals against the speed of the shot, for both keepers."""
    names = {name: f"{name}, far post" for name in KEEPERS}
    names |= {f"near {name}": f"{name}, near post" for name in KEEPERS if f"near {name}" in samples}
    curves = curves_by_bin(samples, names, samples["speed"], BINS, mean, place_scale=1.0)
    words = ("Goals of shots at the goalkeeper", "speed at the kick [m/s]", "goals [%]")
    return (Figure(*words, curves, rules=(50.0,), rule="half of them"),)


H18 = Claim(
    id="H18",
    section="4",
    statement="On the line d, with its delay, a goalkeeper concedes most shots at the farther post.",
    method=f"{SHOTS} {SHOT_TEXT}: the farther post, passive keeper on its half circle.",
    criteria=(
        measured("shots that go in", "passive", unit="%", at_least=50.0),
        reported(f"of those up to {SLOWER:g} m/s", conceded_share, "passive", SLOWER, unit="%"),
        reported("on the goal line instead of the half circle", "line", unit="%"),
        reported("at the nearer post", "near passive", unit="%"),
    ),
    measure=compare_posts,
    seconds=8.0,
    batches=4,
    figures=goals_by_speed_figure,
    ingredients=INGREDIENTS,
    note=f"{CHOSEN} A kicked ball slides first and rolls on at 0.6 of its speed; shots in the paper's words are not.",
)

H19 = Claim(
    id="H19",
    section="4",
    statement="Even with its delay the active goalkeeper has a high chance to intercept the ball.",
    method=f"{SHOTS} {SHOT_TEXT}: the farther post, active keeper.",
    criteria=(
        measured(f"shots saved, {SPEEDS[0]:g} to {SPEEDS[1]:g} m/s", lambda s: 100 - conceded_share(s, "active"),
                 unit="%", at_least=80.0),
        reported(f"of those up to {SLOWER:g} m/s", lambda s: 100 - conceded_share(s, "active", SLOWER), unit="%"),
        reported("of those at 8 m/s and more", lambda s: 100 - 100 * mean(s["active"][s["speed"] >= 8.0]), unit="%"),
        reported("at the nearer post", lambda s: 100 - conceded_share(s, "near active"), unit="%"),
    ),
    measure=compare_posts,
    seconds=8.0,
    batches=4,
    figures=goals_by_speed_figure,
    ingredients=INGREDIENTS,
    note=CHOSEN,
)  # fmt: skip

H20 = Claim(
    id="H20",
    section="4",
    statement="Moving into the predicted trajectory drastically reduces goals by shots at the farther post.",
    method=f"{SHOTS} {SHOT_TEXT}: the farther post, the same shots at both keepers.",
    criteria=(
        measured("active keeper's goals over the passive one's", conceded_ratio, at_most=0.5),
        measured(f"the same up to {SLOWER:g} m/s", conceded_ratio, SLOWER, at_most=0.2),
        reported("goals, passive", "passive", unit="%"),
        reported("goals, active", "active", unit="%"),
        reported("half circle of 0.8 m, passive", "nearer passive", unit="%"),
        reported("half circle of 0.8 m, active", "nearer active", unit="%"),
        reported("goal line, passive", "line passive", unit="%"),
        reported("goal line, active", "line active", unit="%"),
    ),
    measure=compare_keeper_lines,
    seconds=9.0,
    batches=6,
    figures=goals_by_speed_figure,
    ingredients=INGREDIENTS,
    note=f"{CHOSEN} Tribots 2005 stood 0.8 m before the goal, and many keepers of these years on its line.",
)

H23 = Claim(
    id="H23",
    section="4",
    statement="The passive goalkeeper is too static until the ball is passing it.",
    method=f"{SHOTS} {SHOT_TEXT}: the farther post; how far the keeper has moved when the ball is past it, saved "
    "or in.",
    criteria=(
        measured("active keeper's way over the passive one's (means)",
                 lambda s: mean(s["active way"]) / mean(s["passive way"]), above=2.0),
        reported("passive keeper's way", "passive way", unit="cm"),
        reported("active keeper's way", "active way", unit="cm"),
    ),
    measure=compare_saves,
    seconds=3.0,
    batches=6,
    ingredients=INGREDIENTS,
    note=CHOSEN,
)  # fmt: skip

NOISES = {"own": 0.7, "tenfold": 7.0, "thirtyfold": 21.0}  # [px] sd of a blob's place in the image
FITS: dict[str, dict[str, Any]] = {"kalman": {}, "fit": {"filter": "least-squares", "window": 5.0}}
TRIED = (("fit", "own"), ("fit", "tenfold"), ("fit", "thirtyfold"), ("kalman", "own"), ("kalman", "thirtyfold"))


def compare_camera_noise(batch: Batch) -> Samples:
    """Return goals (M,) against both keepers by camera noise, with a fit over five frames or a Kalman filter."""
    samples: Samples = {}
    for fit, noise in TRIED:
        more: dict[str, Any] = {"sensors": {"pixel_noise": NOISES[noise]}, "memory": FITS[fit], "shots": FEWER}
        faced = {name: face_shots(batch, settings | LINES["line"], **more) for name, settings in KEEPERS.items()}
        samples |= {f"{fit} {noise} {name}": one.goal.astype(float) for name, one in faced.items()}
        samples[f"{fit} {noise} error"] = faced["active"].error
    return samples


def prevented_goals(samples: Samples, fit: str, noise: str) -> float:
    """Return how many goals in a hundred shots the active keeper prevents, compared with the passive keeper."""
    return 100.0 * mean(samples[f"{fit} {noise} passive"] - samples[f"{fit} {noise} active"])


def prevented_goals_figure(samples: Samples) -> Sequence[Figure]:
    """Plot the prevented goals against the error of the believed ball."""
    curves = tuple(
        Curve(
            text,
            [100.0 * mean(samples[f"{fit} {noise} error"]) for tried, noise in TRIED if tried == fit],
            [prevented_goals(samples, fit, noise) for tried, noise in TRIED if tried == fit],
        )
        for fit, text in (("kalman", "Kalman filter"), ("fit", "fit over five frames"))
    )
    return (Figure("What the active keeper spares", "error of the believed ball [cm]", "goals [%]", curves),)


H22 = Claim(
    id="H22",
    section="4",
    statement="The active goalkeeper needs the ball's velocity from good tracking.",
    method=f"{FEWER} {SHOT_TEXT}: the farther post, both keepers on the goal line, blobs displaced by a noise of "
    "0.7 px (the sensor's own) to 21 px, velocities by the Kalman filter and by a fit over five frames.",
    criteria=(
        measured("goals spared at the sensor's own noise", prevented_goals, "fit", "own", unit="%", above=10.0),
        measured("goals spared at 30 times the noise, fit over five frames", prevented_goals, "fit", "thirtyfold",
                 unit="%", at_most=5.0),
        reported("goals spared at 10 times the noise", prevented_goals, "fit", "tenfold", unit="%"),
        reported("at 30 times, Kalman filter", prevented_goals, "kalman", "thirtyfold", unit="%"),
        reported("error of the ball at 10 times", "fit tenfold error", unit="cm"),
        reported("error of the ball at 30 times", "fit thirtyfold error", unit="cm"),
    ),
    measure=compare_camera_noise,
    seconds=10.5,
    batches=5,
    figures=prevented_goals_figure,
    ingredients=INGREDIENTS,
)  # fmt: skip
