"""Every statistic with its unit and definition, and the statistics of matches as plain numbers from a team's side.

A number of a team comes twice: `shots_for` is its own, `shots_against` its opponents'.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.statistics.records import BINS_PER_OCTAVE, SHORTEST, STATISTICS, GoalKind
from soccer_env.types import Foul, Phase

PLAYED, IN_PLAY, MATES, PRESENT = "played", "in_play", "mates", "present"
RATE, SHARE, MOST, LENGTH = "rate", "share", "most", "length"
SIDES = ("for", "against")
RESTARTS = tuple(p for p in Phase if p not in (Phase.PLAY, Phase.OVER))
PERCENTS = {"spell_median": 0.5, "spell_90": 0.9}
LENGTHS = "spell_lengths"


@dataclass(frozen=True)
class Statistic:
    """The definition of one statistic: a number for each match, or for each team of a match."""

    name: str
    unit: str  # of one match; reports give counts a minute and times as shares
    text: str  # its definition, a sentence
    team: bool
    kind: str = RATE  # how matches are combined: RATE a minute, SHARE of `whole`, the MOST, a LENGTH of spells
    whole: str = PLAYED
    field: str = ""  # of the record
    column: int | None = None  # of the field


def match_statistic(
    name: str, unit: str, text: str, kind: str = RATE, whole: str = PLAYED, field: str = ""
) -> Statistic:
    """Return the definition of a statistic with one number for each match."""
    return Statistic(name, unit, text, False, kind, whole, field or name)


def team_statistic(
    name: str, unit: str, text: str, kind: str = RATE, whole: str = PLAYED, field: str = ""
) -> Statistic:
    """Return the definition of a statistic with one number for each team."""
    return Statistic(name, unit, text, True, kind, whole, field or name)


def statistic_by_code(prefix: str, codes: Any, text: str, field: str) -> tuple[Statistic, ...]:
    """Return one team statistic for each code, such as each kind of goal; {} in the text is the code's name."""
    return tuple(
        Statistic(
            f"{prefix}_{code.name.lower()}", "", text.format(code.name.lower().replace("_", " ")), True,
            field=field, column=int(code),
        )
        for code in codes
    )  # fmt: skip


GOAL_TEXTS = {
    GoalKind.CLEAN_KICK: "by a kick, or a push as fast as one, that nobody else touched",
    GoalKind.DEFLECTED_KICK: "by a kick or such a push that another robot touched within the last 1 s",
    GoalKind.CLEAN_DRIBBLE: "carried or pushed in by a robot that touched no opponent in the last 3 s",
    GoalKind.PUSHED_IN: "carried or pushed in by a robot that touched an opponent in the last 3 s",
    GoalKind.SCRUM: "bumped in out of a scrum by a robot that had not kept the ball for 1 s",
    GoalKind.OWN_GOAL: "last touched by an opponent, and no kick of the scorers before that",
}
FIGURES: tuple[Statistic, ...] = (
    match_statistic("played", "s", "Time of the match.", SHARE),
    match_statistic("in_play", "s", "Time with the ball in play: no restart is being placed or waited for.", SHARE),
    match_statistic("still", "s", "Time in play with the ball slower than 2 cm/s.", SHARE, IN_PLAY),
    match_statistic("at_boards", "s", "Time in play with the ball within 20 cm of a goal line or touchline.", SHARE,
        IN_PLAY),
    match_statistic("in_corner", "s", "Time in play with the ball within 25 cm of two such lines.", SHARE, IN_PLAY),
    match_statistic(
        "scrum", "s",
        "Time in play with three robots or more whose centres are within 30 cm (middle size: 50 cm) of the ball.",
        SHARE, IN_PLAY,
    ),
    match_statistic("possession_both", "s", "Time in play with the ball at robots of both teams.", SHARE, IN_PLAY,
        "both"),
    match_statistic("separations", "", "How often the referee pulls opponents apart."),
    match_statistic("drops", "", "How often the referee drops the ball."),
    match_statistic("carried", "m", "Greatest distance that a drop or a separation moved a robot.", MOST),
    team_statistic(
        "possession", "s", "Time in play with the ball in the pocket or at the kicker of this team alone.",
        SHARE, IN_PLAY,
    ),
    team_statistic("spells", "", "How often a robot gets the ball; breaks of up to 0.5 s do not count."),
    team_statistic("spell_time", "s", "Time of all spells, of several robots at once as well.", SHARE, IN_PLAY),
    team_statistic("longest_spell", "s", "Longest spell of one robot.", MOST),
    team_statistic("spell_median", "s", "Median length of a spell, to 12 %.", LENGTH, field=LENGTHS),
    team_statistic("spell_90", "s", "Length that 90 % of the spells stay below, to 12 %.", LENGTH, field=LENGTHS),
    team_statistic("touches", "", "Touches of the ball in play by a robot that has not touched it for 1 s."),
    team_statistic("kicks", "", "Kicks that reach the ball."),
    team_statistic(
        "shots", "",
        "Kicks, and pushes that leave the ball free and faster than robots go and than the weakest kick, after which "
        "it would roll over the opponents' goal line between the posts or at most a quarter of the goal's width from "
        "one.",
    ),
    team_statistic("on_target", "", "Shots that would roll between the posts, or do so."),
    team_statistic("saves", "", "Opponents' shots on target that this goalkeeper touches first and that are no goals."),
    team_statistic(
        "passes_tried", "",
        "Balls, no shots, that are free for 0.25 s and that another robot then touches more than 0.3 m (middle size: "
        "1 m) from where they were played.",
    ),
    team_statistic("passes", "", "Such balls that a mate touches: completed passes."),
    team_statistic("interceptions", "", "Such balls of the opponents that this team touches."),
    team_statistic(
        "mates", "s", "Time in play of field players that are not nearest to the ball in their team.", SHARE, IN_PLAY
    ),
    team_statistic(
        "idle", "s", "Time in which such a field player moves slower than 1 cm/s (middle size: 5 cm/s).", SHARE, MATES
    ),
    team_statistic("present", "s", "Time in play of the robots on the pitch, of all together.", SHARE, IN_PLAY),
    team_statistic(
        "stuck", "s",
        "Time of those that are stuck: a robot that aims at 15 % of its top speed or more makes less than a quarter of "
        "what it aims at, for 1.5 s and more; breaks of up to 0.5 s do not end it.",
        SHARE, PRESENT,
    ),
    team_statistic(
        "distance", "m",
        "Distance covered in play by all robots together: their centres' way from control step to control step.",
    ),
    team_statistic(
        "keeper_away", "s", "Time in play with the goalkeeper a quarter of the pitch from its goal.", SHARE, IN_PLAY
    ),
    team_statistic("keeper_in_goal", "s", "Time in play with the goalkeeper behind its goal line.", SHARE, IN_PLAY),
    team_statistic("out", "s", "Time of penalties, of all robots together.", SHARE),
    team_statistic("annulled", "", "Goals that the referee annuls."),
    Statistic("goals", "", "Goals.", True),
    *(
        Statistic(f"goals_{kind.name.lower()}", "", f"Goals {text}.", True, field="goals", column=int(kind))
        for kind, text in GOAL_TEXTS.items()
    ),
    team_statistic("goals_after_separation", "", "Goals within 6 s of a separation.", field="after_separation"),
    team_statistic(
        "goals_after_pushed_keeper", "",
        "Goals within 10 s of a time in which the goalkeeper had been in contact with opponents for 1 s.",
        field="after_pushed_keeper",
    ),
    team_statistic("goals_solo", "",
        "Goals of which one robot of the scorers alone touched the ball since the restart.",
            field="solo"),
    *statistic_by_code("goals_after", RESTARTS, "Goals within 10 s of the ball coming into play by a {}.",
        "after_restart"),
    *statistic_by_code("restarts", RESTARTS, "Restarts for this team by a {}; the first kick-off is not called.",
        "restarts"),
    *statistic_by_code("fouls", [f for f in Foul if f != Foul.NONE], "Whistles against this team for {}.", "fouls"),
)  # fmt: skip


def statistics_by_name(statistics: np.ndarray, team: int) -> dict[str, np.ndarray]:
    """Return the statistics of M matches by name, each (M,), seen from the side of a team (HOME or AWAY)."""
    numbers: dict[str, np.ndarray] = {}
    for figure in FIGURES:
        values = statistic_values(statistics, figure)
        if not figure.team:
            numbers[figure.name] = values
            continue
        for side, of in zip(SIDES, (team, 1 - team), strict=True):
            numbers[f"{figure.name}_{side}"] = values[:, of]
    return numbers


def statistic_values(statistics: np.ndarray, figure: Statistic) -> np.ndarray:
    """Return the values of one statistic in M matches: (M,), or (M, 2) with one for each team."""
    if figure.name == "goals":
        return np.asarray(statistics["goals"].sum(axis=-1))
    values = statistics[figure.field]
    if figure.kind == LENGTH:
        return spell_quantile(values, PERCENTS[figure.name])
    return np.asarray(values if figure.column is None else values[..., figure.column])


def spell_quantile(counts: np.ndarray, share: float) -> np.ndarray:
    """Return the quantile `share` of the spells' lengths [s], from a histogram (..., BINS); 0 without spells."""
    total = np.cumsum(counts, axis=-1)
    place = (total >= share * total[..., -1:]).argmax(axis=-1)
    middle = SHORTEST * 2.0 ** ((place + 0.5) / BINS_PER_OCTAVE)
    return np.where(total[..., -1] > 0, middle, 0.0)


def flatten_statistics(record: Any, team: int) -> dict[str, float]:
    """Return the statistics of one match by name, counts and times [s], seen from the side of a team."""
    one = np.array([record], STATISTICS)
    return {name: values.item() for name, values in statistics_by_name(one, team).items()}
