"""Measure the speed of the package: `soccer bench`. Speeds are compared within one run; no test measures time.

settings.py    the command's options
benchmark.py   the rows of the report as medians of interleaved timings, and a description of the machine
loads.py       timed loads: the core in random and chaser play, the physics alone, pictures with overlays
plans.py       timed loads: one pass and one plan of the middle-size planner, and its team
apis.py        memory of a match, start-up times, and loads that take turns
profile.py     --profile: the time of each mechanism in a match step
growth.py      --growth: the order in which costs grow with robots, matches and the length of a replay
soak.py        --soak: memory, open files and time over millions of match steps
against.py     --against: the ratio of two checkouts' times, with its interval
peers.py       --peers: the ratio to other environments, which pip installs
peer_worker.py the process that times one of them, or both leagues beside it
worker.py      PettingZoo's step and reset, a branch; the process that times one checkout for --against
"""

from collections.abc import Callable
from typing import Any


def measure_speed(settings: Any) -> tuple[dict[str, Any], Callable[[dict[str, Any]], Any]]:
    """Run the measurement that BenchSettings ask for; return its report, and the function that draws it as a table."""
    from soccer_env.train.bench import against, benchmark, growth, peers, profile, soak

    if settings.against is not None:
        return against.compare_checkouts(settings), against.screen_table
    if settings.peers:
        return peers.compare_peers(settings), peers.screen_table
    kinds = {profile.profile_step: settings.profile, growth.measure_growth: settings.growth}
    chosen = [run for run, asked in {**kinds, soak.measure_soak: settings.soak}.items() if asked]
    run = chosen[0] if chosen else benchmark.run_benchmark
    return run(settings), benchmark.screen_table
