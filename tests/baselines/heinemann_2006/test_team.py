"""heinemann-2006 plays from beliefs alone, left as right, and the same to the last bit."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match, make_team
from soccer_env.baselines.heinemann_2006.memory import ATTACKER, DEFENDER, KEEPER, MEMORY, SUPPORTER
from soccer_env.baselines.heinemann_2006.roles import choose_role
from soccer_env.baselines.heinemann_2006.settings import HeinemannSettings, settings_records
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.skills.sight import SIGHT
from soccer_env.teams import CompiledTeam, TeamRandom, View
from soccer_env.types import NOISE_STREAMS
from tests.scenes.sacks_beliefs import draw_beliefs, draw_tracks
from tests.scenes.staging import MIDDLE, play
from tests.scenes.symmetry import mirrored_actions, mirrored_beliefs, mirrored_tracks

LEAGUE = find_league(MIDDLE)
K = constants_of(LEAGUE)[0]
MATCHES, PLAYERS, SLOTS, FIELD = 40, 5, 9, 4.0  # FIELD: times the legged field
NAMES = ("heinemann-2006", "weigel-2001")
MIRROR = 1e-9


def commands_of(team: CompiledTeam, beliefs: np.ndarray, tracks: np.ndarray, memory: np.ndarray) -> np.ndarray:
    """Return the commands (M, P, 7) of one decision."""
    rng = TeamRandom(np.zeros((MATCHES, PLAYERS, NOISE_STREAMS), np.uint64), np.arange(PLAYERS))
    return team.act(View(LEAGUE, beliefs, tracks), memory, rng)


def drawn(rng: np.random.Generator, reach: float = FIELD) -> tuple[np.ndarray, np.ndarray]:
    """Return beliefs and tracks (M, P), mostly likely ones."""
    shape = (MATCHES, PLAYERS)
    return draw_beliefs(rng, shape, reach), draw_tracks(rng, shape, SLOTS, reach)


def test_switches_are_named_and_checked_and_the_legged_league_is_refused() -> None:
    team = make_team("heinemann-2006:planner=static,keeper=passive,velocity=False")
    row = team.settings[1]
    assert (row["planner"], row["keeper"], row["velocity"], row["ways"]["time_variant"][0]) == (1, 1, 0, 0)
    assert make_team("heinemann-2006").settings["ways"][1] == PlannerSettings().record()  # as claims measure it alone
    assert make_team("weigel-2001").settings.tobytes() == make_team("heinemann-2006:planner=static").settings.tobytes()
    for message, name in (
        ("HeinemannSettings.keeper must be one of active, passive, got 'brave'", "heinemann-2006:keeper=brave"),
        ("'keper' in HeinemannSettings, did you mean 'keeper'", "heinemann-2006:keper=passive"),
    ):
        with pytest.raises(ValueError, match=message):
            make_team(name)
    for name in NAMES:
        with pytest.raises(ValueError, match=f"{name}.* middle-size.*, 'legged-2001' is .*legged"):
            Match("legged-2001", controllers={"home": name}, seed=1)


def test_the_same_seed_is_the_same_match_to_the_last_bit_alone_or_beside_others() -> None:
    def played(matches: int) -> bytes:
        match = Match(MIDDLE, home=3, away=3, matches=matches, seeds=list(range(7, 7 + matches)),
                      controllers={"home": "heinemann-2006", "away": "weigel-2001"}, senses="sensors")  # fmt: skip
        play(match, steps=250)
        return match.robots[:1].tobytes() + b"".join(squad.memory[:1].tobytes() for squad in match.squads)

    assert played(1) == played(1) == played(3)


@pytest.mark.parametrize("settings", [{}, {"keeper": "passive", "stance": "line"}, {"planner": "static"}])
def test_it_plays_the_mirrored_scene_in_the_mirror(settings: dict[str, Any]) -> None:
    team, rng = make_team("heinemann-2006", **settings), np.random.default_rng(4)
    memory, image = (np.zeros((MATCHES, PLAYERS), team.memory_dtype) for _ in range(2))
    roles = set()
    for _ in range(8):
        beliefs, tracks = drawn(rng)
        for _ in range(6):
            commands = commands_of(team, beliefs, tracks, memory)
            other = commands_of(team, mirrored_beliefs(beliefs), mirrored_tracks(tracks), image)
            assert np.abs(mirrored_actions(other) - commands).max() <= MIRROR
            roles |= set(np.unique(memory["role"]).tolist())
    assert (memory["role"] == image["role"]).all()
    np.testing.assert_allclose(image["drive_y"], -memory["drive_y"], atol=MIRROR)
    assert roles == {KEEPER, ATTACKER, DEFENDER, SUPPORTER}


@pytest.mark.parametrize("strength", [0.0, 1.0])
def test_commands_are_finite_whatever_is_believed(strength: float) -> None:
    team, rng = make_team("heinemann-2006", strength=strength), np.random.default_rng(5)
    memory = np.zeros((MATCHES, PLAYERS), team.memory_dtype)
    for step in range(40):
        beliefs, tracks = drawn(rng, 10.0 ** rng.integers(-12, 9))
        if step % 3 == 0:  # nobody seen yet, everybody at the same place
            beliefs["ball"]["age"], tracks["distance"], tracks["x"], tracks["y"] = np.inf, 0.0, 0.0, 0.0
        commands = commands_of(team, beliefs, tracks, memory)
        assert np.isfinite(commands).all() and np.abs(commands).max() <= 1.0 + 1e-9
        assert np.isfinite(memory["drive_x"]).all() and np.isfinite(memory["drive_y"]).all()


@pytest.mark.parametrize(("cycle", "steps"), [(0.02, 1), (0.04, 2), (0.1, 5)])
def test_mh03_it_decides_anew_every_20_ms_or_once_in_a_longer_cycle(cycle: float, steps: int) -> None:
    team, rng = make_team("heinemann-2006", cycle=cycle), np.random.default_rng(6)
    memory, last, anew = np.zeros((MATCHES, PLAYERS), team.memory_dtype), None, []
    for _ in range(11):
        commands = commands_of(team, *drawn(rng), memory)
        anew.append(last is None or bool((commands != last).any()))
        last = commands.copy()
    assert np.flatnonzero(anew).tolist() == list(range(0, 11, steps))


def seen(x: float, mates: list[tuple[float, float]]) -> np.void:
    """Return what a field player at (x, 0) sees, the ball on the centre spot."""
    sight = np.zeros(1, SIGHT)[0]
    sight["x"], sight["others"], sight["elapsed"] = x, len(mates), 0.02
    for i, (mate_x, mate_y) in enumerate(mates):
        sight["other_x"][i], sight["other_y"][i] = mate_x, mate_y
        sight["mate"][i] = sight["field"][i] = 1
    return sight


def test_mh23_one_attacks_one_defends_and_the_others_support() -> None:
    places = [(-1.0, 0.0), (-2.5, 0.0), (-3.0, 2.5), (-3.0, -3.0)]
    play, ranks = settings_records(HeinemannSettings())[1], []
    for i, (x, y) in enumerate(places):
        sight, memory = seen(x, places[:i] + places[i + 1 :]), np.zeros(1, MEMORY)[0]
        sight["y"] = y
        choose_role(sight, memory, K, play)
        ranks.append((int(memory["role"]), int(memory["skill"]["rank"])))
    assert ranks == [(ATTACKER, 0), (DEFENDER, 1), (SUPPORTER, 2), (SUPPORTER, 3)]


def test_mh23_a_role_is_given_up_for_somebody_clearly_nearer_after_a_while() -> None:
    play, memory = settings_records(HeinemannSettings(role_gain=0.4, role_time=0.3))[1], np.zeros(1, MEMORY)[0]
    choose_role(seen(-1.0, [(-1.2, 0.0)]), memory, K, play)
    assert memory["role"] == ATTACKER
    for _ in range(50):
        choose_role(seen(-1.0, [(-0.7, 0.0)]), memory, K, play)  # nearer by less than the gain
    assert memory["role"] == ATTACKER
    for _ in range(15):
        choose_role(seen(-1.0, [(-0.5, 0.0)]), memory, K, play)  # 0.5 m nearer, for 0.3 s
        assert memory["role"] == ATTACKER
    choose_role(seen(-1.0, [(-0.5, 0.0)]), memory, K, play)
    assert memory["role"] == DEFENDER
