"""The pages of claims: all results for each paper, as `soccer reproduce ID --stored` prints them."""

from __future__ import annotations

from soccer_env.train.papers.report import EXPLANATION, claim_result_markdown
from soccer_env.train.papers.results import FOLDERS, read_stored, stored_results


def pages() -> dict[str, str]:
    """Return the page of each paper by its path."""
    found = {}
    for paper, folder in FOLDERS.items():
        told = [claim_result_markdown(result) for result in stored_results(read_stored(folder))]
        found[f"claims/{folder.name}.md"] = "\n\n".join([f"# Claims of {paper}, measured", EXPLANATION, *told]) + "\n"
    return found


def navigation() -> list[object]:
    """Return the section of the claims."""
    return [{"Claims": [{paper: f"claims/{folder.name}.md"} for paper, folder in FOLDERS.items()]}]
