"""Names in a stranger's replay are shown without what moves the terminal's cursor."""

import numpy as np

from soccer_env.replay import Replay


def test_a_replay_is_shown_in_one_plain_line_whoever_named_its_teams() -> None:
    teams = {"home_0": "\x1b[2J\x1b[31mred\nline", "away_0": "x" * 1000}
    replay = Replay({"teams": teams}, b"", np.zeros(0), np.zeros(0), [], [])
    shown = repr(replay)
    assert shown.isprintable() and len(shown) < 250
    assert shown.startswith(r"<Replay of \x1b[2J\x1b[31mred\nline against xxx")
