"""A report page as a single HTML file: parts in order, every text escaped, with style and pictures inside."""

import html
import re
from collections.abc import Iterable, Sequence
from importlib.resources import files
from urllib.parse import quote

from soccer_env.shows import browser
from soccer_env.shows.browser.page import fill_template
from soccer_env.train.report.style import COLOURS, adapt_svg

DARK_COLOURS = ("#86b4ff", "#ff9d5c", "#46c878", "#d590ea", "#d6bf4a", "#ff8a94")  # of curves, in the order of COLOURS
ROOT = re.compile(r':root(\[data-theme="dark"\])? \{[^}]*\}')  # of the replay's style: its colours
NUMBER = re.compile(r"[-+±]?\d[\d,.:]*(\s?(%|s|s?/min|m|cm|kB|MB))?( \(.*\))?|[-?]|\d+ : \d+|\d+(, \d+)+")


class ReportPage:
    """The page of a report; `what` is the command that made it; markup in texts is shown literally."""

    def __init__(self, title: str, what: str) -> None:
        self._title, self._what = title, what
        self._parts: list[str] = []
        self._sections: list[str] = []
        self._figures = 0

    def say(self, text: str, strong: bool = False) -> None:
        """Add a paragraph to the page; text between `backticks` is code."""
        if text:
            start = '<p class="lead">' if strong else "<p>"
            self._parts.append(f"{start}{to_html(text)}</p>")

    def section(self, title: str) -> None:
        """Begin a section, linked from the top of the page."""
        self._sections.append(title)
        self._parts.append(f'<h2 id="section{len(self._sections)}">{to_html(title)}</h2>')

    def heading(self, title: str) -> None:
        """Begin a subsection with a title."""
        self._parts.append(f"<h3>{to_html(title)}</h3>")

    def table(self, head: Sequence[str], rows: Iterable[Sequence[str]], sorts: bool = False) -> None:
        """Add a table with right-aligned numbers; `sorts`: tapping a column's head sorts by that column."""
        self._table(head, [(row, "") for row in rows], ' class="sorts"' if sorts else "")

    def links(self, head: Sequence[str], rows: Iterable[tuple[Sequence[str], Sequence[tuple[str, str]]]]) -> None:
        """Add a table whose rows are texts followed by links (words, file beside the page)."""
        self._table(head, [(texts, f"<td>{' '.join(link(*one) for one in those)}</td>") for texts, those in rows])

    def _table(self, head: Sequence[str], rows: list[tuple[Sequence[str], str]], kind: str = "") -> None:
        """Add a table of texts; each row may end with cells of HTML markup."""
        kinds = [alignment([texts[at] for texts, _ in rows if at < len(texts)]) for at in range(len(head))]
        heads = "".join(f'<th scope="col"{one}>{to_html(name)}</th>' for name, one in zip(head, kinds, strict=True))
        body = "".join(
            f"<tr>{''.join(f'<td{one}>{to_html(text)}</td>' for text, one in zip(texts, kinds))}{end}</tr>"
            for texts, end in rows
        )
        top = f"<thead><tr>{heads}</tr></thead>" if any(head) else ""
        self._parts.append(f'<div class="wide" tabindex="0"><table{kind}>{top}<tbody>{body}</tbody></table></div>')

    def figure(self, svg: bytes, caption: str) -> None:
        """Add a picture (SVG) that a function of `train.report` has drawn with form="svg"."""
        self._figures += 1
        drawn = adapt_svg(svg, f"figure{self._figures}")
        drawn = drawn.replace("<svg", f'<svg role="img" aria-label="{html.escape(caption)}"', 1)
        self._parts.append(
            f'<figure><div class="plot" tabindex="0">{drawn}</div><figcaption>{to_html(caption)}</figcaption></figure>'
        )

    def command(self, text: str) -> None:
        """Add a command as a block of code."""
        self._parts.append(f"<pre>{html.escape(text)}</pre>")

    def fold(self, summary: str) -> None:
        """Begin a folded part that the reader can open; `unfold` ends it."""
        self._parts.append(f"<details><summary>{to_html(summary)}</summary>")

    def unfold(self) -> None:
        """End the folded part that `fold` began."""
        self._parts.append("</details>")

    def html(self) -> str:
        """Return the whole page as HTML."""
        names = "".join(f'<a href="#section{n}">{to_html(name)}</a>' for n, name in enumerate(self._sections, 1))
        filled = {
            "TITLE": html.escape(self._title),
            "WHAT": to_html(self._what),
            "STYLE": style(),
            "SECTIONS": names,
            "BODY": "\n".join(self._parts),
            "SCRIPT": read_part("report.js"),
        }
        return fill_template(read_part("report.html"), filled)


def to_html(text: str) -> str:
    """Escape a text for HTML, and turn text between `backticks` into code."""
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", html.escape(text))


def alignment(texts: Sequence[str]) -> str:
    """Return the HTML class for a column's cells: the class of numbers if most texts are numbers, else ""."""
    told = [bool(NUMBER.fullmatch(text)) for text in texts if text]
    return ' class="number"' if told and 2 * sum(told) > len(told) else ""


def link(words: str, file: str) -> str:
    """Return an HTML link to a file beside the page."""
    return f'<a href="{html.escape(quote(file))}">{to_html(words)}</a>'


def style() -> str:
    """Return the CSS of a page: shared colours of the browser replay, colours of curves, and report.css."""
    light, dark = (
        rule.group() for rule in list(ROOT.finditer(files(browser).joinpath("look.css").read_text("utf-8")))[:2]
    )
    for colours, which in ((COLOURS, "light"), (DARK_COLOURS, "dark")):
        added = " ".join(f"--c{n}: {colour};" for n, colour in enumerate(colours, 1)) + " }"
        if which == "light":
            light = light.removesuffix("}") + added
        else:
            dark = dark.removesuffix("}") + added
    system = dark.replace(':root[data-theme="dark"]', ':root:not([data-theme="light"])')
    return f"{light}\n{dark}\n@media (prefers-color-scheme: dark) {{ {system} }}\n{read_part('report.css')}"


def read_part(name: str) -> str:
    """Return the text of the file `name` beside this module."""
    return files(__package__).joinpath(name).read_text(encoding="utf-8")
