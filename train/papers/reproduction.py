"""Measure the papers' claims: batch by batch, until the interval decides or the cap is reached.

    results = reproduce(ReproduceSettings(claims=("S05",), quick=True))

`examination.py` examines one claim. With several threads, claims are measured in separate processes (`workers.py`),
because most of a claim's time is spent in Python.
"""

import json
from collections.abc import Mapping, Sequence

from soccer_env.train.cluster import open_workers
from soccer_env.train.papers.claim import Claim
from soccer_env.train.papers.claims import all_claims, find_claims
from soccer_env.train.papers.examination import examine
from soccer_env.train.papers.report import markdown, page_of
from soccer_env.train.papers.results import CLAIMS, REPRODUCTION, ClaimResult, plot_name, stored_results
from soccer_env.train.papers.settings import ReproduceSettings, command_of
from soccer_env.train.papers.workers import examine_in_processes, examine_in_tasks
from soccer_env.train.progress import Progress
from soccer_env.train.provenance import LIBRARIES, date_and_commit, digest, module_hash, play_facts, version_of
from soccer_env.train.report import MISSING, can_draw, draw_curves
from soccer_env.train.results_folder import ResultsFolder
from soccer_env.types import WORLD


def reproduce(settings: ReproduceSettings, *, known: Mapping[str, Claim] | None = None) -> list[ClaimResult]:
    """Measure the claims whose results settings.out lacks, and return the results of all claims.

    With settings.stored, measure nothing and return the stored results. `known`: a user's own claims, which replace the
    package's claims. Raises ValueError for an unknown id and for a folder with another run.
    """
    if settings.stored:
        return stored_results(settings.claims)
    ours = known is None
    if settings.ray is not None and not ours:
        raise ValueError("ray measures the claims of the package alone: other claims may be functions of this process")
    known = all_claims() if known is None else known
    claims = find_claims(settings.claims or [claim.id for claim in known.values() if not claim.study], known)
    conditions = {
        "claims": [claim.id for claim in claims], "budget": settings.budget, "pose": settings.pose,
        "rules": settings.rules, "seeds": list(settings.seeds),
    }  # fmt: skip
    about = {"command": command_of(settings), **date_and_commit(), **play_facts()}
    folder = ResultsFolder(settings.out, REPRODUCTION, conditions, made_with(claims), about, settings.anew)
    done = measure_missing(claims, settings, folder, ours)
    results = [done[claim.id] for claim in claims]
    folder.write("results.json", json.dumps([result.as_dict() for result in results], indent=2) + "\n")
    plots, trouble = draw_all(results, folder)
    folder.write("report.md", markdown(results, folder, plots, trouble))
    if folder.path is not None:
        folder.write("report.html", page_of(results, folder))
    return results


def made_with(claims: list[Claim]) -> dict[str, str]:
    """Return the library versions and the hashes of match and claim code on which results depend."""
    # func: of a partial
    modules = sorted({getattr(claim.measure, "func", claim.measure).__module__ for claim in claims})
    code = {"code": module_hash("soccer_env.match.match"), "claims": digest("".join(map(module_hash, modules)))}
    return {name: version_of(name) for name in LIBRARIES} | {"world": str(WORLD)} | code


def measure_missing(
    claims: list[Claim], settings: ReproduceSettings, folder: ResultsFolder, ours: bool
) -> dict[str, ClaimResult]:
    """Measure every claim whose result the folder lacks; return the results of all claims by id.

    Only claims of the package (`ours`) are measured in several processes: other claims may be functions that no other
    process can import.
    """
    done = folder.results(CLAIMS, ClaimResult, "id")
    missing = [claim for claim in claims if claim.id not in done]
    caps = {claim.id: settings.cap(claim.batches, claim.quick, claim.seconds, len(claims)) for claim in missing}
    work = {claim.id: caps[claim.id] * claim.seconds * len(settings.seeds) for claim in missing}
    longest_first = {name: caps[name] for name in sorted(caps, key=lambda name: -work[name])}
    with (
        Progress("reproduce", sum(work.values())) as progress,
        open_workers(settings.threads, settings.ray) as workers,
    ):
        run = (longest_first, settings, folder.settings, lambda name: progress.advance(work[name]))
        if not isinstance(workers, int):
            found = examine_in_tasks(workers, *run)
        elif ours and workers > 1 and len(missing) > 1:
            found = examine_in_processes(*run)
        else:
            advance = progress.advance
            found = (examine(claim, settings, caps[claim.id], folder.settings, advance) for claim in missing)
        progress.note(f"{len(done)} of {len(claims)} done")
        for result in found:
            done[result.id] = result
            folder.add(CLAIMS, [result])
            progress.note(f"{result.id}: {result.verdict}, {len(done)} of {len(claims)} done")
    return done


def draw_all(results: Sequence[ClaimResult], folder: ResultsFolder) -> tuple[dict[str, list[str]], str]:
    """Plot every figure into the folder; return the files of each claim, and the reason if nothing was plotted."""
    if folder.path is None or not any(result.figures for result in results):
        return {}, ""
    if not can_draw():
        return {}, MISSING
    files: dict[str, list[str]] = {}
    for result in results:
        for number, figure in enumerate(result.figures, 1):
            name = plot_name(result.id, number)
            folder.write(name, draw_curves(figure))
            files.setdefault(result.id, []).append(name)
    return files, ""
