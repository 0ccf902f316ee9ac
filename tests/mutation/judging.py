"""Whether a slip is noticed: tests run in a copy with the slip in it until one fails that passes without."""

from __future__ import annotations

import re
import signal
from typing import NamedTuple

from tests.mutation.related import Related, module_of
from tests.mutation.running import FAILING, Copy, Ran, StoppedError

BROKEN = re.compile(r"^E? +.*\b(SyntaxError|NameError|TypingError|LoweringError|UnsupportedError)\b", re.MULTILINE)
NONE_CHOSEN = 5  # pytest's exit code when there is no test to run
OUT_OF_TIME = (-signal.SIGXCPU, -signal.SIGKILL)
Stage = tuple[list[str], tuple[str, ...]]  # files of tests, and options of pytest
FAST, SLOW = ("-m", "not slow"), ("-m", "slow")


class Verdict(NamedTuple):
    """What became of a mutant, by which test, after how much processor time."""

    word: str  # killed, killed (time), killed (died), lived, invalid, unfinished
    by: str  # the test, or the stage that was not finished
    seconds: float


def stages(related: Related, file: str) -> list[Stage]:
    """Return which tests to ask, one stage after another: those about the file, the quick ones, the slow ones."""
    first = related.first(file)
    return [(first, FAST), *((quick, FAST) for quick in related.then(first)), (first[:6], SLOW)]


def verdict_on(copy: Copy, file: str, text: str, asked: list[Stage], begin: int = 0) -> Verdict:
    """Return what tests say to a file with another text, from the stage on to which an earlier run came."""
    seconds = 0.0
    stage = begin
    with copy.changed(file, text):
        try:
            for tests, options in asked[begin:]:
                while chosen := [test for test in tests if test not in copy.ground.failing]:
                    left = [f"--deselect={test}" for test in sorted(copy.ground.failing)]
                    ran = copy.run_tests(chosen, *options, *left)
                    seconds += ran.seconds
                    if ran.code in (0, NONE_CHOSEN):
                        break
                    verdict = judged(copy, file, ran)
                    if verdict and (verdict[0] != "killed" or fails_again(copy, verdict[1])):
                        return Verdict(*verdict, seconds)
                stage += 1
        except StoppedError:
            return Verdict("unfinished", str(stage), seconds)
    return Verdict("lived", "", seconds)


def fails_again(copy: Copy, test: str) -> bool:
    """Tell whether a test fails a second time; one that does not is asked no more, for it fails by chance."""
    if "::" not in test or copy.run_tests([test]).code != 0:
        return True
    copy.ground.failing.add(test)
    return False


def judged(copy: Copy, file: str, ran: Ran) -> tuple[str, str] | None:
    """Return a verdict and the test that gave it; None if the test fails without the slip as well."""
    if BROKEN.search(ran.output):
        return "invalid", BROKEN.search(ran.output)[1]  # type: ignore[index]
    if ran.code < 0:
        word = "killed (time)" if ran.code in OUT_OF_TIME else "killed (died)"
        return (word, ran.last) if not ran.last or copy.ground.passes(ran.last) else None
    failing = FAILING.findall(ran.output)
    if not failing or any("::" not in test for test in failing):
        imported = copy.run_python("-c", f"import {module_of(file)}", cache=copy.cache)
        if imported.code:
            return "invalid", "import"
    if not failing:
        return "killed", f"exit code {ran.code}: {ran.output[-300:]}"
    guilty = [test for test in failing if copy.ground.passes(test)]
    return ("killed", guilty[0]) if guilty else None
