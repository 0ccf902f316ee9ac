"""The style of all plots: sizes, fonts, colours, and markers, lines and hatches readable without colour."""

import io
import itertools
import re
from collections.abc import Callable, Iterator
from functools import wraps
from typing import Any, Literal, ParamSpec

P = ParamSpec("P")
Form = Literal["png", "svg"]

MISSING = 'plots need matplotlib: pip install "soccer_env[plot]" and run the same command again'
WIDTH = 6.4  # [inch] of every picture of one panel: pages and READMEs show them side by side
HEIGHT = 3.7  # [inch] of its axes with title and labels, without the legend
LEGEND_ROW = 0.21  # [inch]
LONG = 38  # letters of a name beyond which a legend has one column
DOTS = 110  # [1/inch]
INK, DIM, LINE = "#171b22", "#5c6675", "#d6dae1"  # text; what is beside the point; grid: as the browser replay has them
COLOURS = ("#1f4e9c", "#c4541a", "#0f7a43", "#8a3fa0", "#766200", "#b3263c")  # each as dark as print needs
MARKERS = ("o", "s", "^", "v", "D", "P")
LINES = ("-", "--", "-.", ":", (0, (5, 1)), (0, (3, 1, 1, 1, 1, 1)))
HATCHES = ("", "///", "---", "xxx", "\\\\\\", "+++")
VARIABLES = {INK: "--ink", DIM: "--dim", LINE: "--line", "#ffffff": "--panel"} | {
    colour: f"--c{number}" for number, colour in enumerate(COLOURS, 1)
}  # of a page's style, by which an SVG is drawn in its colours
STYLE: Any = {
    "figure.dpi": DOTS, "savefig.dpi": DOTS, "figure.facecolor": "#ffffff", "axes.facecolor": "none",
    "font.family": "sans-serif", "font.sans-serif": ["DejaVu Sans"], "font.size": 9.5,
    "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": DIM, "xtick.color": DIM, "ytick.color": DIM,
    "xtick.labelcolor": INK, "ytick.labelcolor": INK, "axes.titlecolor": INK,
    "axes.titlesize": 10.5, "axes.titleweight": "bold", "axes.titlelocation": "left",
    "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.8,
    "axes.grid": True, "axes.axisbelow": True, "grid.color": LINE, "grid.linewidth": 0.7,
    "lines.linewidth": 1.6, "lines.markersize": 4.5, "hatch.linewidth": 0.7,
    "legend.frameon": False, "legend.fontsize": 9.0, "legend.handlelength": 3.2,
    "text.parse_math": False,  # a team may be called $x$
    "svg.fonttype": "none", "svg.hashsalt": "soccer_env",
}  # fmt: skip
Look = tuple[str, str, Any]  # colour, marker and line


def can_draw() -> bool:
    """Tell whether matplotlib is installed."""
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        return False
    return True


def curve_styles() -> Iterator[Look]:
    """Yield a new combination of colour, marker and line style for each curve of a plot."""
    return itertools.cycle(zip(COLOURS, MARKERS, LINES, strict=True))


def canvas(height: float = HEIGHT, width: float = WIDTH, rows: int = 1, columns: int = 1, **shared: Any) -> Any:
    """Return a new figure [inch] with one axes or an array (rows, columns) of them, independent of pyplot."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    return figure, figure.subplots(rows, columns, **shared)


def label_axes(axes: Any, title: str, x_label: str, y_label: str) -> None:
    """Set title and axis labels (quantity and unit) of a plot; a title wider than the plot is wrapped."""
    from textwrap import fill

    axes.set_title(fill(title, 76), wrap=False)
    axes.set_xlabel(x_label)
    axes.set_ylabel(y_label)


def use_whole_ticks(axis: Any) -> None:
    """Place the ticks of an axis at whole numbers only."""
    from matplotlib.ticker import MaxNLocator

    axis.set_major_locator(MaxNLocator(integer=True))


def add_legend(figure: Any, axes: Any) -> None:
    """Place the legend below the axes, where it hides no curve, and enlarge the figure for it."""
    handles, names = axes.get_legend_handles_labels()
    if not handles:
        return
    columns = 1 if max(map(len, names)) > LONG else min(2, len(names))
    rows = -(-len(names) // columns)
    figure.set_figheight(figure.get_figheight() + LEGEND_ROW * rows + 0.1)
    figure.legend(handles, names, loc="outside lower left", ncols=columns)


def picture_maker(make: Callable[P, Any]) -> Callable[..., bytes]:
    """Turn a function that returns a matplotlib figure into a function that returns a picture's bytes.

    The picture depends on the arguments alone. `form`: "png", or "svg" for a page. ImportError without matplotlib.
    """

    @wraps(make)
    def drawn(*args: Any, form: Form = "png", **settings: Any) -> bytes:
        try:
            import matplotlib
        except ImportError as error:
            raise ImportError(MISSING) from error
        with matplotlib.rc_context(STYLE):
            figure = make(*args, **settings)
            file = io.BytesIO()
            about = {"Software": ""} if form == "png" else {"Date": None, "Creator": None}
            figure.savefig(file, format=form, metadata=about, transparent=form == "svg")
        return file.getvalue()

    return drawn


def adapt_svg(svg: bytes, name: str) -> str:
    """Adapt an SVG to a page: use the page's colour variables, and begin all ids with `name`."""
    text = svg.decode()
    text = re.sub(r'(?<= d=")[^"]+', lambda found: shorten_svg_path(found[0]), text[text.index("<svg") :])
    text = re.sub(r'(<rect [^>]*) fill="(#\w{6})"', r'\1 style="fill: \2"', text)  # where variables hold
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r'\bid="', f'id="{name}-', text)
    text = re.sub(r'href="#', f'href="#{name}-', text).replace("url(#", f"url(#{name}-")
    for colour, variable in VARIABLES.items():
        text = re.sub(rf"(?<=: ){colour}\b", f"var({variable})", text)
    # The size of the page's column, not of a printed one.
    return re.sub(
        r'(<svg[^>]*?) width="[^"]*"', r"\1", re.sub(r'(<svg[^>]*?) height="[^"]*"', r"\1", text, count=1), count=1
    )


def shorten_svg_path(path: str) -> str:
    """Shorten an SVG path by rounding to hundredths of a point and dropping repeated letters."""
    text = " ".join(re.sub(r"(\.\d\d)\d+", r"\1", path).split())
    return re.sub(r"[ML] \S+ \S+(?: L \S+ \S+)+", lambda lines: lines[0].replace(" L ", " "), text)
