"""The report of an evaluation as a page for the browser: the Markdown report with pictures and replays."""

from collections.abc import Callable, Iterator, Sequence

from soccer_env.train.evaluate.map_pictures import check_maps, map_rows, pass_rows
from soccer_env.train.evaluate.replays import Kept
from soccer_env.train.evaluate.replays.keep import add_replays
from soccer_env.train.evaluate.report import conditions_rows, needed_matches_sentence, pair_rows, rows, verdict_sentence
from soccer_env.train.evaluate.results import EvaluationResult, pair_means
from soccer_env.train.evaluate.statistics import goal_rows, play_rows
from soccer_env.train.report import MISSING, ReportPage, can_draw, draw_bars, draw_curves
from soccer_env.train.report.pitch_maps import draw_map
from soccer_env.train.statistics import paired_bootstrap

LOOKS = 24  # points of the curve of the mean over pairs
Drawn = tuple[bytes, str]  # an SVG and its caption
FigureMaker = Callable[[EvaluationResult], Iterator[Drawn]]


def page_of(result: EvaluationResult, about: dict[str, str], kept: Sequence[Kept] = ()) -> str:
    """Return the report as an HTML page; `about`: command, date and commit of the evaluation."""
    conditions = result.conditions
    page = ReportPage(f"{conditions.home} against {conditions.away}", f"soccer evaluate, {conditions.league}")
    page.say(verdict_sentence(result), strong=True)
    page.section("Result")
    page.table(("", "value", "95 % interval"), rows(result))
    page.say(
        f"Results are {conditions.home}'s; intervals are 95 % bootstraps over pairs. {needed_matches_sentence(result)}"
    )
    add_figures(page, result)
    add_replays(page, kept)
    head = ("", conditions.home, conditions.away)
    if result.statistics:
        page.section("Play")
        page.table(head, play_rows(result.statistics))
        page.say(
            "One value is of both teams together. `soccer list statistics` says what each is; result.json has all."
        )
        page.heading("How goals fell")
        page.table(head, goal_rows(result.statistics))
    add_maps(page, result, head)
    page.section("Conditions")
    page.say("This command plays what is missing and writes this report again:")
    page.command(about.get("command", ""))
    page.table(("", ""), conditions_rows(result, about))
    page.section("Matches")
    page.fold(f"scores of {len(result.lines) // 2} pairs, {conditions.home} first")
    columns, pairs, rest = pair_rows(result)
    page.table(columns, pairs, sorts=True)
    page.unfold()
    page.say(rest)
    return page.html()


def add_figures(page: ReportPage, result: EvaluationResult) -> None:
    """Add the plots of FIGURE_MAKERS to the page, or a sentence that names the missing package."""
    if not can_draw():
        page.say(MISSING[0].upper() + MISSING[1:])
        return
    for make in FIGURE_MAKERS:
        for drawn in make(result):
            page.figure(*drawn)


def add_maps(page: ReportPage, result: EvaluationResult, head: tuple[str, str, str]) -> None:
    """Add the tables and pictures of maps to the page, unless the result has no maps."""
    if not result.maps:
        return
    page.section("Where it happened")
    if can_draw() and "pitch" in result.maps:
        maps = check_maps(result.maps, (result.conditions.home, result.conditions.away))
        for kind, caption in MAPS:
            page.figure(draw_map(maps, kind, form="svg"), caption)
    page.table(head, map_rows(result.maps))
    page.heading("Completed passes")
    page.table(("from, to", *head[1:]), pass_rows(result.maps))
    page.say("Players are numbered from 0, the goalkeeper.")
    page.say("`soccer export result.json --maps --out maps.png` draws these as one picture.")


def draw_differences(result: EvaluationResult) -> Iterator[Drawn]:
    """Plot a histogram of the matches' goal differences."""
    ended = [line.goals_for - line.goals_against for line in result.lines]
    kinds = {
        "won": [difference for difference in ended if difference > 0],
        "drawn": [difference for difference in ended if difference == 0],
        "lost": [difference for difference in ended if difference < 0],
    }
    groups = [
        (name, sorted(set(values)), [values.count(difference) for difference in sorted(set(values))])
        for name, values in kinds.items()
        if values
    ]
    mean = result.goal_difference
    mark = (f"mean {mean.mean:+.2f} ({mean.low:+.2f} to {mean.high:+.2f})", mean.mean, mean.low, mean.high)
    title = f"Goal differences of {len(result.lines)} matches"
    yield (
        draw_bars(title, "goals - goals against in a match", "matches", groups, mark, form="svg"),
        f"How the matches ended for {result.conditions.home}; the bar above is the mean with its 95 % interval.",
    )


def draw_mean(result: EvaluationResult) -> Iterator[Drawn]:
    """Plot the mean goal difference of the first n pairs with its 95 % interval, against n."""
    means = pair_means(result.lines, lambda line: line.goals_for - line.goals_against)
    if len(means) < 3:
        return
    counts = sorted({round(2 + (len(means) - 2) * look / (LOOKS - 1)) for look in range(LOOKS)})
    intervals = [paired_bootstrap(means[:count]) for count in counts]
    value, low, high = (list(values) for values in zip(*intervals, strict=True))
    curve = {"name": "mean, 95 % interval", "x": counts, "y": value, "low": low, "high": high}
    figure = {
        "title": "Mean goal difference, pair by pair", "x_label": "pairs of matches", "rules": [0.0], "rule": "even",
        "y_label": "goals - goals against, a match", "curves": [curve],
    }  # fmt: skip
    yield draw_curves(figure, form="svg"), "How sure the mean has become: what the first pairs alone would have said."


MAPS = (
    ("presence", "Where robots and the ball were; each team attacks to the right, the ball is seen with the first."),
    ("network", "Mean places of players, and completed passes from one to another. Discs that would hide each other "
     "are moved apart."),
    ("shots", "From where shots were taken, and what became of them; each team attacks to the right."),
)  # fmt: skip
FIGURE_MAKERS: list[FigureMaker] = [draw_differences, draw_mean]  # pictures of the page, in order
