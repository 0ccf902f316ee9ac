"""The HTML report of a training run: its learning curve, evaluations, statistics of PPO, and settings."""

from collections.abc import Iterator, Sequence
from typing import Any

from soccer_env.train.ppo.reports import EVALUATIONS, curve_of, evaluation_rows, merit, name_of, step_unit
from soccer_env.train.ppo.settings import TrainSettings, command_of
from soccer_env.train.provenance import LIBRARIES, date_and_commit, version_of
from soccer_env.train.report import MISSING, ReportPage, can_draw, draw_curves, draw_heat_table

MOST_COLUMNS = 9  # evaluations in the table of opponents
POINTS = 300  # of a curve of the log
COURSES = (  # title, quantity, and which numbers of the log's lines
    ("Points won against opponents in training", "points (a draw is half)", ("points",)),
    ("How far each update went", "divergence, share", ("kl", "clipped")),
    ("The critic", "explained variance", ("explained",)),
    ("Noise of the actions", "standard deviation", ("noise",)),
    ("Learning rate of the actor", "rate", ("learning_rate",)),
)
Lines = Sequence[dict[str, Any]]


def page_of(settings: TrainSettings, lines: Lines, evaluations: Lines) -> str:
    """Return the HTML page of a run, made from its log `lines` and its evaluations."""
    page = ReportPage(f"{settings.name}, {settings.league}, {settings.players}", "soccer train")
    if evaluations:
        best = max(evaluations, key=merit)
        points, goals = merit(best)
        page.say(
            f"Best: {100.0 * points:.0f} % of points and {goals:+.2f} goals a match on average, "
            f"after {best['step']:,} steps.", strong=True,
        )  # fmt: skip
        page.say("The largest of several is a lucky one: evaluate best.safetensors with another seed.")
        add_evaluations(page, settings, evaluations)
    if lines:
        page.section("Training")
        for figure in curves_of_log(lines) if can_draw() else ():
            page.figure(draw_curves(figure, form="svg"), figure["title"])
        last = lines[-1]["seconds"]
        page.table(("last rollout", "seconds"), [(name, f"{value:.2f}") for name, value in last.items()])
    page.section("Conditions")
    page.say("This command goes on with the run, and writes this report again:")
    page.command(command_of(settings))
    made = {**date_and_commit(), **{name: version_of(name) for name in (*LIBRARIES, "torch", "stable-baselines3")}}
    page.table(("", ""), list(made.items()))
    page.fold("all settings")
    page.table(("setting", "value"), [(name, str(value)) for name, value in settings.as_dict().items()])
    page.unfold()
    return page.html()


def add_evaluations(page: ReportPage, settings: TrainSettings, evaluations: Lines) -> None:
    """Add the learning curve and the evaluations to the page, as tables too."""
    page.section("Evaluations")
    if can_draw():
        page.figure(
            draw_curves(curve_of(evaluations, settings), form="svg"), "The policy without noise, 95 % intervals."
        )
        page.figure(opponents_table(evaluations), "Goals - goals against, a match: blue above 0, hatched below.")
    else:
        page.say(MISSING[0].upper() + MISSING[1:])
    page.table(EVALUATIONS, evaluation_rows(evaluations), sorts=True)


def opponents_table(evaluations: Lines) -> bytes:
    """Draw a table of goal differences by opponent and evaluation; of many evaluations only a selection."""
    every = -(-len(evaluations) // MOST_COLUMNS)
    shown = list(range(len(evaluations) - 1, -1, -every))[::-1]
    unit, words = step_unit(max(one["step"] for one in evaluations))
    columns = [f"{evaluations[at]['step'] / unit:.3g}" for at in shown]
    opponents = [name_of(row) for row in evaluations[-1]["rows"]]
    values = [[evaluations[at]["rows"][index]["goal_difference"] for at in shown] for index in range(len(opponents))]
    title = "Goal difference a match"
    return draw_heat_table(title, opponents, columns, values, f"decisions{words}", "against", form="svg")


def curves_of_log(lines: Lines) -> Iterator[dict[str, Any]]:
    """Yield the arguments of `draw_curves` for each quantity in a run's log."""
    lines = lines[:: max(1, len(lines) // POINTS)]
    unit, words = step_unit(max(line["step"] for line in lines))
    for title, quantity, names in COURSES:
        columns: dict[str, list[Any]] = {}
        for name in names:
            if isinstance(lines[-1].get(name), dict):
                columns |= {key: [line[name].get(key) for line in lines] for key in lines[-1][name]}
            else:
                columns[name] = [line.get(name) for line in lines]
        curves = [
            {"name": name, "x": [line["step"] / unit for line in lines], "y": values, "low": [], "high": []}
            for name, values in columns.items()
            if any(value is not None for value in values)
        ]
        if curves:
            yield {"title": title, "x_label": f"decisions{words}", "y_label": quantity, "curves": curves, "rules": []}
