"""A ball hidden in both dimensions, and the correction by the infrared ranger.  [Sacks 2001, 3.1.1]"""

import numpy as np

from soccer_env.train.papers.claim import STAGED, Batch, Claim
from soccer_env.train.papers.claims.ball.occlusion import CUT, SCENES, draw_scene, visible_shares, watch_scene
from soccer_env.train.papers.claims.ball.range import OLD
from soccer_env.train.papers.values import known, ratio
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

DEEP = 2.0 / 3.0  # [1] visible share of both dimensions below which a right reading is under 2/3 of the range by size
FAR = 0.60  # [m] range along the ground from the camera


def compare_infrared_rule(batch: Batch) -> Samples:
    """Return range errors (M, T) [m] of balls cut in width and height, infrared rule on and off, and false triggers.

    "on", "off": visible shares below DEEP, camera's axis on the ball; "all ...": shares below DEEP, all frames with the
    ball; "mild ...": shares below CUT, axis on the ball. "triggers": readings that the rule changes on free balls.
    """
    scene = draw_scene(batch)
    width, height, _ = visible_shares(batch, scene)
    samples = {}
    for name, rule in (("on", True), ("off", False)):
        seen = watch_scene(batch, scene, True, False, OLD | {"infrared_override": rule})
        error, near = np.abs(seen["error"] * seen["range"]), seen["range"] <= FAR
        deep, mild = (((width < share) & (height < share))[:, None] & near for share in (DEEP, CUT))
        samples[name] = np.where(deep & seen["centred"], error, np.nan)
        samples[f"all {name}"] = np.where(deep, error, np.nan)
        samples[f"mild {name}"] = np.where(mild & seen["centred"], error, np.nan)
        samples[f"short {name}"] = np.where(deep & seen["centred"], seen["short"], np.nan)
        samples[f"free {name}"] = watch_scene(batch, scene, False, True, OLD | {"infrared_override": rule})["believed"]
    judged = np.isfinite(samples["free off"])
    samples["triggers"] = (judged & (np.abs(samples["free on"] - samples["free off"]) > 1e-6)).sum(axis=1)
    samples["judged"] = judged.sum(axis=1)
    return samples


S09 = Claim(
    id="S09",
    section="3.1.1",
    statement="Infrared, where below 2/3 of the range by size, repairs obstruction in both dimensions.",
    method=f"{SCENES}, robots tracking what they see; balls of which less than 2/3 is left in both dimensions (of "
    "others the size says less than 3/2 of the range, and the rule has no business), up to 60 cm away, in frames "
    "in which the camera's axis meets the ball; and the same balls unobstructed, at the centre, for false triggers.",
    criteria=(
        measured("mean error with the rule over that without", ratio, "on", "off", at_most=0.5),
        counted("unobstructed frames in which the rule changes the range", "triggers", "judged", at_most=2.0),
        reported("the first ratio in all frames of these balls", ratio, "all on", "all off"),
        reported(f"the first ratio of balls of which less than {100 * CUT:.0f} % is left in both", ratio, "mild on",
                 "mild off"),
        reported("mean error without the rule", "off", unit="cm"),
        reported("the same in all frames of these balls", "all off", unit="cm"),
        reported("frames in which the ranger reads something more than 10 cm before the ball", "short off", unit="%"),
        reported("frames of hidden balls that count", lambda samples: float(len(known(samples["off"])))),
    ),
    rules=STAGED,
    measure=compare_infrared_rule,
    least=4,
    ingredients=("sensors.infrared_pointing, infrared_growth", "memory.centred", "belief/legged/head.py"),
)  # fmt: skip
