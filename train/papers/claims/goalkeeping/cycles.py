"""The length of a player's decision cycle: 20 ms, 40 ms or 100 ms.  [Heinemann et al. 2006, 2]"""

from collections.abc import Sequence

from soccer_env.train.papers.claim import STAGED, Batch, Claim, Curve, Figure
from soccer_env.train.papers.claims.goalkeeping.passes import BALL_TEXT, receive
from soccer_env.train.papers.claims.goalkeeping.shots import SHOT_TEXT, SHOTS, face_shots
from soccer_env.train.papers.values import mean
from soccer_env.train.papers.verdicts import Samples, measured, reported

CYCLES = (0.02, 0.04, 0.1)  # [s]


def compare_cycles(batch: Batch) -> Samples:
    """Return which shots are saved and which rolling balls are received (M,), for each length of the decision cycle."""
    samples: Samples = {}
    for cycle in CYCLES:
        samples[f"saved {cycle:g}"] = 1.0 - face_shots(batch, {"cycle": cycle}).goal.astype(float)
        samples[f"had {cycle:g}"] = receive(batch, {"cycle": cycle})["got"]
    return samples


def share_gain(samples: Samples, name: str, slow: float, fast: float) -> float:
    """Return the gain [%] in the share `name` from the cycle `slow` to the cycle `fast`."""
    return 100.0 * mean(samples[f"{name} {fast:g}"] - samples[f"{name} {slow:g}"])


def cycle_figure(samples: Samples) -> Sequence[Figure]:
    """Plot the shares of saved shots and of received balls against the length of the decision cycle."""
    names, times = {"saved": "far-post shots saved", "had": "rolling balls had"}, [1000.0 * cycle for cycle in CYCLES]
    curves = tuple(
        Curve(text, times, [100.0 * mean(samples[f"{name} {cycle:g}"]) for cycle in CYCLES])
        for name, text in names.items()
    )
    return (Figure("What a shorter cycle is worth", "cycle [ms]", "share [%]", curves),)


H28 = Claim(
    id="H28",
    section="2",
    statement="A cycle of 20 ms makes the robot extremely reactive.",
    method=f"{SHOTS} {SHOT_TEXT}; {BALL_TEXT}. Decisions every 20, 40 and 100 ms, the camera and the delay "
    "as they are.",
    criteria=(
        measured("more saves at 20 than at 100 ms, of 100", share_gain, "saved", 0.1, 0.02, above=0.0),
        measured("more balls had at 20 than at 100 ms, of 100", share_gain, "had", 0.1, 0.02, above=0.0),
        measured("saves at 40 ms above 100 ms, of 100", share_gain, "saved", 0.1, 0.04, at_least=-5.0),
        measured("saves at 20 ms above 40 ms, of 100", share_gain, "saved", 0.04, 0.02, at_least=-5.0),
        reported("balls had at 20 ms above 40 ms, of 100", share_gain, "had", 0.04, 0.02),
        reported("saves at 20 ms", "saved 0.02", unit="%"),
        reported("balls had at 20 ms", "had 0.02", unit="%"),
    ),
    rules=STAGED,
    measure=compare_cycles,
    seconds=12.0,
    batches=4,
    figures=cycle_figure,
    ingredients=("camera and delay stay at 50 Hz and 0.1 s: only decisions are rarer",),
)
