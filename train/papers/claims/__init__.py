"""The claims of the two papers, a folder for each theme, each claim with its own measurement.

To add a claim:

1. Write a module in the folder of its theme (or extend one) with `S99 = claim("S99", section, statement, method,
   *criteria, measure=...)`; other modules hold helpers of their folder. `statement` is one sentence of at most 17
   words: it is a row of the team's page.
2. `rules` names the rule sets of its matches: STAGED (`stage`, `drill`; the default), PLAYED (`kick_off`), both, or
   NO_MATCH; a match under other rules is refused. Measurements skip robots that are sent off (`active`).
3. `measure(batch)` stages many matches at once (`../staging.py`: stage, put, put_ball, begin_scene, play, record),
   plays them, and returns arrays whose first axis is independent units (normally the matches); NaN stands for "no
   value". All randomness comes from `batch.seeds(n)` and `batch.rng()`. Variants use the same seeds, which pairs them.
4. Criteria (`../verdicts.py`): `measured` (any quantity of the samples, bootstrap over units), `counted` (share of hits
   among trials in each unit), `exact` (arithmetic), `reported` (decides nothing: what no figure and no other criterion
   shows). All must hold. The text names the number in a few words; the bound is the requirement, by the words of the
   sentence, which `method` quotes where they were in question. `EXPLANATION` of `../report.py` says how several
   criteria are combined.
5. `without=Ablation(ingredient, measure)` marks a claim by construction: its criteria are measured without the
   ingredient, too.
6. One batch should take 2 to 3 s compiled on one core; write this time into `seconds`, the cap into `batches`
   (default run: at most about 2 minutes a claim). `figures(samples)` returns plain data, which the report draws;
   `../plots.py` makes most. `condition` is what the verdict must name: "reproduced, where ...". `shared` lets claims
   share scenes, `compare` measures variants, `timed` says that samples are times, which nobody can replay. A change of
   the question and the likely cause of a "not" are a line each in remarks.json of the paper's team.
7. `soccer reproduce ID --quick`; a test in tests/train/papers holds every module to these rules.

Measure the paper's words over the range that they name; a claim that does not hold is a finding.

    ball/            finding and following the ball       players/         recognising and remembering other players
    stuck/           detecting that a robot is stuck      dribble/         keeping the ball, past others
    field/           the potential field                  goalkeeper.py    a goalkeeper's use of ball velocities
    planning/        the planners of 2006                 goalkeeping/     goalkeeper and receiver of 2006
    middle_size.py   middle-size vision and own pose      sensors.py       errors of all sensors over the range
"""

from collections.abc import Iterable, Mapping
from importlib import import_module
from pkgutil import walk_packages

from soccer_env.guards.names import unknown
from soccer_env.train.papers.claim import Claim


def all_claims() -> dict[str, Claim]:
    """Return the claims of every module in this folder, by id; studies come last."""
    modules = [import_module(found.name) for found in walk_packages(__path__, f"{__name__}.")]
    claims = [value for module in modules for value in vars(module).values() if isinstance(value, Claim)]
    return {claim.id: claim for claim in sorted(claims, key=lambda claim: (claim.study, claim.id))}


def find_claims(ids: Iterable[str], known: Mapping[str, Claim]) -> list[Claim]:
    """Look up claims by id, without duplicates; ValueError, with the known ids, for an unknown id."""
    wanted = list(dict.fromkeys(ids))
    for name in wanted:
        if name not in known:
            raise ValueError(unknown("claim", name, known))
    return [known[name] for name in wanted]
