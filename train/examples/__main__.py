"""Run an example and print its result: python -m soccer_env.train.examples NAME [--steps 10000]."""

import ast
import importlib
import re
import sys
import time
from pathlib import Path

import tyro

FOLDER = Path(__file__).parent
PAGES = sorted({file.stem for file in FOLDER.glob("*.py")} - {"__init__", "__main__", "empty_goal", "monte_carlo"})


def needs(name: str) -> str:
    """Return the packages that an example needs, as arguments of pip."""
    line = re.search(r"^Needs: (.+)$", example_docstring(name), re.MULTILINE)
    return line[1] if line else ""


def example_docstring(name: str) -> str:
    """Return the docstring of an example."""
    return ast.get_docstring(ast.parse((FOLDER / f"{name}.py").read_text(encoding="utf-8"))) or ""


def help_text() -> str:
    """Return the usage, and the first line and packages of each example."""
    lines = ["usage: python -m soccer_env.train.examples NAME [--steps 10000] [OPTIONS]", ""]
    for name in PAGES:
        lines += [f"  {name:18}{example_docstring(name).splitlines()[0]}", f"  {'':18}needs: {needs(name)}"]
    return "\n".join([*lines, "", "`NAME --help` explains the options of one, once what it needs is installed."])


def main() -> None:
    """Run the example that the first word names; the other words are arguments of its `main`."""
    name = sys.argv[1] if len(sys.argv) > 1 else ""
    if name in ("-h", "--help"):
        print(help_text())
        return
    if name not in PAGES:
        sys.exit(f"name an example: {', '.join(PAGES)}; got {name!r}")
    started = time.perf_counter()
    try:
        page = importlib.import_module(f"soccer_env.train.examples.{name}")
    except ModuleNotFoundError as error:
        more = f"{name} needs {needs(name)}, which pip installs beside 'soccer_env[train]'"
        sys.exit(f"{error}: {more}; in a checkout `make example-{name}` does so and runs it")
    reached = tyro.cli(page.main, args=sys.argv[2:], prog=f"python -m soccer_env.train.examples {name}")
    seconds = time.perf_counter() - started
    print(f"{name}: reached {reached:.2f} in {seconds:.0f} s, {time.process_time():.0f} s of the processor")


if __name__ == "__main__":
    main()
