"""The mutants of the mutation check: mechanism, piece of source, what replaces it, and the test that must notice."""

from __future__ import annotations

from typing import NamedTuple


class Mutant(NamedTuple):
    """One mechanism switched off."""

    id: str
    file: str
    original: str
    replacement: str
    test: str


MUTANTS = [
    Mutant(
        "MS07",
        "soccer_env/physics/drive.py",
        "    robot.pan = toward(robot.pan,",
        "    robot.pan = toward(0.0 * robot.pan,",
        "tests/test_mechanisms.py::test_ms07_the_head_keeps_the_ball_ahead_of_the_camera",
    ),
    Mutant(
        "MH01",
        "soccer_env/physics/drive.py",
        "    robot.walk.left += share * aside",
        "    robot.walk.left += 0.5 * share * aside",
        "tests/test_mechanisms.py::test_mh01_the_omnidirectional_base_reaches_its_top_speed_in_every_direction",
    ),
    Mutant(
        "MH04",
        "soccer_env/physics/kicker.py",
        "    ball.vx += speed * ahead",
        "    ball.vx += 0.5 * speed * ahead",
        "tests/test_mechanisms.py::test_mh04_the_kicker_shoots_as_hard_as_it_is_told",
    ),
]
