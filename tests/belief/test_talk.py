"""What is said arrives late, at team-mates alone, or is lost for all; four bits tell how far the ball is."""

from math import inf

import numpy as np
import pytest
from scipy.stats import binomtest

from soccer_env import Match
from soccer_env.records.ball_words import FARTHEST, GROWTH, NEAREST, SILENT, distance_of_word, word_for_distance
from tests.belief.staged_talk import Talkers
from tests.scenes.staging import MIDDLE, each_league

RATE = 16  # [1/s] control steps of the legged league
LATE = 8  # frames that a word is on its way


def test_ms06_fifteen_words_tell_near_distances_finely_and_far_ones_coarsely() -> None:
    """MS06: four bits are sixteen words, one of which says that the ball is not seen."""
    distances = np.linspace(0.0, 6.0, 20_000)
    words = np.array([word_for_distance(distance) for distance in distances])
    assert set(words) == set(range(1, FARTHEST + 1)) and FARTHEST == 2**4 - 1
    assert (np.diff(words) >= 0).all()
    edges = distances[1:][np.diff(words) > 0]
    assert edges[0] == pytest.approx(NEAREST, abs=1e-3)
    assert edges[1:] / edges[:-1] == pytest.approx(np.full(13, GROWTH), abs=0.01)
    assert edges[-1] > 2.9  # most of a field of 3 x 2 m
    assert word_for_distance(inf) == SILENT and distance_of_word(SILENT) == inf
    assert all(word_for_distance(distance_of_word(word)) == word for word in range(1, FARTHEST + 1))


def test_ms06_a_word_is_heard_by_team_mates_alone_half_a_second_later() -> None:
    talkers = Talkers()
    talkers.see(1, 0.5)
    talkers.step(LATE)
    assert talkers.heard() == [0] * 6 and talkers.heard("distance") == [inf] * 6 and talkers.heard("age") == [inf] * 6
    talkers.step()
    word = word_for_distance(0.5)
    assert talkers.heard() == [word, 0, word, 0, 0, 0] and talkers.heard("distance")[0] == distance_of_word(word)
    assert talkers.heard("age")[:2] == [0.5, inf]


def test_the_team_mate_nearest_to_the_ball_is_heard_and_elevens_do_not_mix_up_the_teams() -> None:
    talkers, elevens = Talkers(home=4, away=2), Talkers(home=11, away=11)
    for r, distance in enumerate((0.9, 0.3, 1.5, 2.0)):
        talkers.see(r, distance)
    for r in range(22):
        elevens.see(r, 0.2 if r == 10 else 0.9)
    for one in (talkers, elevens):
        one.step(LATE + 1)
    near, next_to = word_for_distance(0.3), word_for_distance(0.9)
    assert talkers.heard() == [near, next_to, near, near, 0, 0]
    assert elevens.heard() == [word_for_distance(0.2)] * 10 + [next_to] * 12


def test_four_bits_a_second_are_said_and_no_more() -> None:
    talkers = Talkers()
    words = []
    for frame in range(4 * RATE):
        talkers.see(1, 0.1 + 0.04 * frame)
        talkers.step()
        words.append(talkers.heard()[0])
    changes = np.flatnonzero(np.diff(words)) + 1
    assert len(changes) == 4 and (np.diff(changes) == RATE).all()


def test_a_robot_that_does_not_see_the_ball_says_so_and_a_word_is_forgotten_after_two_periods() -> None:
    blind, talkers = Talkers(), Talkers()
    for one in (blind, talkers):
        one.see(1, 0.3)
        one.step(LATE + 1)
        assert one.heard()[0] == word_for_distance(0.3)
    blind.lose(1)
    blind.step(RATE)
    assert blind.heard()[0] == SILENT
    talkers.percepts["body"]["active"][1] = 0  # sent off: it says nothing more
    talkers.step(2 * RATE)
    assert talkers.heard()[0] == word_for_distance(0.3) and talkers.heard("age")[0] == pytest.approx(2.5)
    talkers.step()
    assert talkers.heard()[0] == SILENT and talkers.heard("distance")[0] == inf


def test_a_lost_word_is_lost_for_all_and_a_share_of_them_is_lost() -> None:
    talkers = Talkers(home=8, away=0, audio_loss=0.2)
    heard = []
    for _ in range(400):
        talkers.beliefs["heard"]["word"] = 0
        talkers.messages["known"] = 0
        talkers.see(1, 0.3)
        talkers.step(RATE)
        found = talkers.heard()
        assert len(set(found[:1] + found[2:])) == 1
        heard.append(found[0] > 0)
    assert np.mean(heard) == pytest.approx(0.8, abs=0.06)


@pytest.mark.parametrize("loss", [0.0, 0.05, 0.5, 1.0])
@each_league
def test_the_share_of_messages_that_is_lost_is_the_one_that_is_set(name: str, loss: float) -> None:
    """MS06 by loudspeaker, MH05 by radio: nobody's message comes through by chance, and none is lost at 0."""
    talkers = Talkers(name, **{"radio_loss" if name == MIDDLE else "audio_loss": loss})
    period = 5 if name == MIDDLE else RATE  # frames between two messages
    sent, arrived = 300, np.zeros(6, int)
    for _ in range(sent):
        talkers.messages["known"] = 0
        talkers.step(period)
        arrived += talkers.messages["known"]
    if loss in (0.0, 1.0):
        assert (arrived == (1.0 - loss) * sent).all()
    else:
        assert min(binomtest(int(sent - one), sent, loss).pvalue for one in arrived) > 1e-4
        assert binomtest(int(6 * sent - arrived.sum()), 6 * sent, loss).pvalue > 1e-3


def test_only_the_rows_that_use_their_sensors_talk_and_swapping_the_teams_swaps_what_is_heard() -> None:
    talkers = Talkers()
    talkers.rows = np.array([0, 2])
    for r in range(3):
        talkers.see(r, 0.3 + 0.3 * r)
    talkers.step(LATE + 1)
    assert talkers.heard() == [word_for_distance(0.9), 0, word_for_distance(0.3), 0, 0, 0]
    assert talkers.messages["known"].tolist() == [1, 0, 1, 0, 0, 0]
    talkers, swapped = Talkers(audio_loss=0.3), Talkers(audio_loss=0.3)
    distances = np.random.default_rng(2).uniform(0.1, 3.0, 6)
    swapped.noise = np.roll(talkers.noise, 3, axis=0)
    for r in range(6):
        talkers.see(r, distances[r])
        swapped.see((r + 3) % 6, distances[r])
    for _ in range(200):
        talkers.step()
        swapped.step()
        assert np.roll(talkers.beliefs["heard"], 3).tobytes() == swapped.beliefs["heard"].tobytes()


def test_mh05_a_radio_message_is_heard_a_few_frames_later_with_its_distance() -> None:
    talkers = Talkers(MIDDLE)
    talkers.see(1, 2.34)
    talkers.step(3)
    assert talkers.heard("distance") == [inf] * 6
    talkers.step()
    assert talkers.heard("distance") == [2.34, inf, 2.34, inf, inf, inf]
    assert talkers.heard("age")[0] == pytest.approx(0.06)
    quiet = Talkers(MIDDLE)
    quiet.settings["shared"] = 0
    quiet.see(1, 2.34)
    quiet.step(20)
    assert quiet.messages["known"].tolist() == [0] * 6


@each_league
def test_ideal_senses_hear_the_truth(name: str) -> None:
    match = Match(name, home=3, away=1, seed=4, senses="ideal", observe="belief")
    heard = match.beliefs["heard"][0]
    away = np.hypot(match.balls["x"] - match.robots["x"][0], match.balls["y"] - match.robots["y"][0])
    assert heard["distance"][:3] == pytest.approx([min(away[1:3]), min(away[[0, 2]]), min(away[:2])])
    assert heard["word"].tolist() == [word_for_distance(distance) for distance in heard["distance"]]
    assert heard["age"].tolist() == [0.0, 0.0, 0.0, inf] and heard["distance"][3] == inf and heard["word"][3] == SILENT
