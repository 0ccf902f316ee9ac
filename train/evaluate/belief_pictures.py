"""How wrong robots are, as a picture: the errors of ball and players against range and age, and of their own places."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from soccer_env.data_out.belief_errors import BeliefErrors
from soccer_env.data_out.collect import MatchRecording
from soccer_env.train.report.charts import draw_curve
from soccer_env.train.report.style import DIM, HEIGHT, add_legend, canvas, curve_styles, label_axes, picture_maker

KINDS = (".png", ".svg")
BINS = 12  # of equally many beliefs each
BAND = (10.0, 50.0, 90.0)  # [%] of the beliefs of a bin
AXES = {"range": "true distance [m]", "age": "time since it was seen [s]"}


def draw_beliefs(matches: Iterable[MatchRecording], form: str) -> bytes:
    """Draw the errors of all robots of matches, of which beliefs were collected; ValueError without a belief."""
    errors = [match.beliefs for match in matches if match.beliefs is not None]
    pose = np.concatenate([one.error[..., 0].ravel() for one in errors])
    if np.isnan(pose).all():
        raise ValueError("no robot of these matches believes anything: record them with senses")
    curves = {axis: [curve_of(name, errors, axis) for name in ("ball", "players")] for axis in AXES}
    return draw_belief_errors(curves, float(np.nanmedian(pose)), form=form)


def curve_of(name: str, errors: Sequence[BeliefErrors], axis: str) -> dict[str, Any]:
    """Return the median error of ball or players against `axis` ("range" or "age"), with the band of 80 %."""
    objects = slice(1, 2) if name == "ball" else slice(2, None)
    error = np.concatenate([one.error[..., objects].ravel() for one in errors])
    along = np.concatenate([getattr(one, axis)[..., objects].ravel() for one in errors])
    known = np.isfinite(error) & np.isfinite(along)
    order = np.argsort(along[known], kind="stable")
    parts = [part for part in np.array_split(order, BINS) if len(part)]
    low, middle, high = ([float(np.percentile(error[known][part], at)) for part in parts] for at in BAND)
    x = [float(np.median(along[known][part])) for part in parts]
    return {"name": f"{name}, median and 80 %", "x": x, "y": middle, "low": low, "high": high}


@picture_maker
def draw_belief_errors(curves: dict[str, list[dict[str, Any]]], pose: float) -> Any:
    """Plot errors against range and age in two panels; `pose`: the median error of the robots' own places [m]."""
    drawn, axes = canvas(2.0 * HEIGHT, rows=2)
    for one, (axis, drawn_curves) in zip(axes, curves.items(), strict=True):
        for curve, look in zip(drawn_curves, curve_styles(), strict=False):
            draw_curve(one, curve, *look)
        one.axhline(pose, color=DIM, linestyle=(0, (6, 3)), label="own place, median")
        one.set_ylim(bottom=0.0)
        label_axes(one, f"Errors of beliefs by {axis}", AXES[axis], "error [m]")
    add_legend(drawn, axes[0])
    return drawn
