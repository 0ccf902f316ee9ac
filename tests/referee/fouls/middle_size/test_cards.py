"""Yellow for a hard foul and for every third, and two of them send a robot off."""

from math import inf

import numpy as np
import pytest

from soccer_env.referee.fouls.middle_size.book import OUT, YELLOW, book
from soccer_env.types import AWAY, HOME
from tests.scenes.referee import Referee
from tests.scenes.staging import asking, stand


def cards(referee, hard):
    """Return the cards and what `book` says, for fouls of robot 1 one after the other."""
    shown = []
    for one in hard:
        referee.deeds["card"] = 0
        out = book(referee.robots, referee.deeds, referee.rows[1], one, referee.k)
        shown.append((int(referee.deeds["card"][referee.rows[1]]), bool(out)))
    return shown


@pytest.mark.parametrize("team", [HOME, AWAY])
def test_every_third_foul_is_a_yellow_card_and_the_sixth_the_end(team):
    referee = Referee(team=team)
    assert cards(referee, [False] * 6) == [(0, False)] * 2 + [(YELLOW, False)] + [(0, False)] * 2 + [(OUT, True)]
    robot = referee.robots[referee.rows[1]]
    assert robot["active"] == 0 and robot["banned"] == 1 and robot["penalty"] == 0.0


def test_a_hard_foul_is_a_yellow_card_at_once():
    referee = Referee()
    assert cards(referee, [True, True]) == [(YELLOW, False), (OUT, True)]


def test_who_is_sent_off_never_comes_back():
    referee = Referee()
    cards(referee, [True, True])
    referee.match.rebuild()
    for _ in range(150):
        referee.match.step(asking(referee.match, referee.rows[1], 1.0))
    assert referee.robots["active"].tolist() == [1, 0, 1, 1, 1, 1]


def test_the_timed_variant_lets_it_come_back_after_its_time():
    referee = Referee(timed_cards=True, card_time=1.0)
    cards(referee, [True, True])
    assert referee.robots["banned"].max() == 0 and referee.robots["penalty"][1] == 1.0
    referee.match.rebuild()
    active = []
    for _ in range(60):
        referee.match.step(stand(referee.match))
        active.append(int(referee.robots["active"][1]))
    assert active.index(1) == 49 and np.isfinite(inf) is not True
    assert abs(referee.robots["x"][1]) < 0.5 and abs(referee.robots["y"][1]) > 3.0


def test_who_came_back_begins_with_a_yellow_card_again():
    referee = Referee(timed_cards=True)
    assert cards(referee, [True] * 4) == [(YELLOW, False), (OUT, True)] * 2


def test_cards_can_be_switched_off():
    referee = Referee(cards=False)
    assert cards(referee, [True] * 4) == [(0, False)] * 4 and referee.robots["fouls"].max() == 0
