"""The shipped teams play at any size, from beliefs alone, left as right; kernels of teams reach every player."""

from importlib.metadata import EntryPoint
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, make_team
from soccer_env.compiled import compiled
from soccer_env.leagues import LEAGUES as ALL_LEAGUES
from soccer_env.teams import ENTRY_POINTS, CompiledTeam, TeamRandom, View, parse_team, registered_teams, registry
from soccer_env.teams.kernels import STRENGTH, per_blind_player, per_player
from soccer_env.types import COMMAND
from tests.scenes.staging import LEAGUES, LEGGED, MIDDLE, place, play, scatter, set_phase, stage
from tests.scenes.symmetry import mirror, turn

TEAMS = ("still", "random", "chaser")
BASES = (LEGGED, MIDDLE, "middle-size-2006-differential")
IMAGED = tuple(team for team in TEAMS if team != "random")  # whose draws have no image
EVEN = ("forward", "kick", "head", "tilt")


def numbers(commands: np.ndarray) -> np.ndarray:
    """Return commands as numbers (..., 7)."""
    return np.stack([commands[name] for name in COMMAND.names or ()], axis=-1)


def test_still_stands_still_and_random_moves_as_strength_says() -> None:
    match, commands = Match(seed=1, controllers={"home": "still", "away": "still"}), {}
    start = match.robots[["x", "y", "heading"]].copy()
    play(match, steps=100)
    assert (match.robots[["x", "y", "heading"]] == start).all()
    for strength in (1.0, 0.5):
        match = Match(seed=1, matches=50, controllers={"home": f"random@{strength}", "away": "still"})
        match.step()
        commands[strength] = numbers(match.robots["command"])[:, :3, :3].copy()
    assert np.abs(commands[1.0]).max() > 0.9
    np.testing.assert_allclose(commands[0.5], 0.5 * commands[1.0])


@pytest.mark.parametrize(
    ("team", "league"), [("chaser", LEGGED), ("chaser", MIDDLE), ("sacks-2001", LEGGED), ("heinemann-2006", MIDDLE)]
)
def test_without_strength_a_player_is_slower_and_decides_less_often(team: str, league: str) -> None:
    ways, decisions = {}, {}
    for strength in (0, 1):
        controllers = {"home": f"{team}@{strength}", "away": "still"}
        match = stage(league, 20, seed=2, controllers=controllers, senses="ideal")
        place(match, robots={0: (-0.4 * match.league.pitch.length, 0.1)})
        commands = []
        for _ in range(80):
            match.step()
            commands.append(numbers(match.robots["command"])[:, 0, :3].copy())
        ways[strength] = match.robots["x"][:, 0].mean() + 0.4 * match.league.pitch.length
        decisions[strength] = (np.diff(commands, axis=0) != 0.0).any(axis=2).mean()
    assert 0.3 < ways[0] / ways[1] < 0.9, ways
    assert decisions[0] < 0.7 * decisions[1], decisions


@pytest.mark.parametrize(("league", "team", "senses"), [
    *((league, team, "sensors") for league in LEAGUES for team in TEAMS),
    *((LEGGED, f"sacks-2001{kind}", senses) for kind in ("", "-tuned", "-future") for senses in ("ideal", "sensors")),
    *((league, team, "sensors") for league in (MIDDLE, BASES[2]) for team in ("heinemann-2006", "weigel-2001")),
])  # fmt: skip
@pytest.mark.parametrize(("home", "away"), [(1, 2), (11, 11)])
def test_every_team_plays_at_every_size(league: str, team: str, senses: str, home: int, away: int) -> None:
    match = Match(league, home=home, away=away, seed=1, controllers={"home": team, "away": team}, senses=senses)
    start = match.robots["x"].copy()
    play(match, steps=200)
    commands = numbers(match.robots["command"])
    assert np.isfinite(commands).all() and np.abs(commands).max() <= 1.0 and np.isfinite(match.robots["x"]).all()
    assert team == "still" or np.abs(match.robots["x"] - start).max() > 0.1


@pytest.mark.parametrize("league", ALL_LEAGUES)
def test_the_chaser_plays_every_league(league: str) -> None:
    match = Match(league, seed=1, matches=4, controllers={"home": "chaser", "away": "still"}, minutes=2)
    while not match.terminated.all():
        match.step()
    assert match.matches["score"][:, 0].sum() > 0 == match.matches["score"][:, 1].sum()


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("team", TEAMS)
def test_act_is_what_the_match_runs(league: str, team: str) -> None:
    match = Match(league, home=3, away=3, seed=1, controllers={"home": team, "away": "still"}, senses="ideal")
    play(match, steps=40)
    squad = match.squads[0]
    view = View(match.league, match.beliefs[:, squad.players].copy(), match.tracks[:, squad.players].copy())
    states, memory = match.robots["noise"].copy(), squad.memory.copy()
    commands = squad.team.act(view, memory, TeamRandom(states, squad.players))
    match.step()
    np.testing.assert_array_equal(commands, numbers(match.robots["command"])[:, squad.players])
    assert memory.tobytes() == squad.memory.tobytes()


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("team", IMAGED)
@pytest.mark.parametrize("change", [mirror, turn])
def test_a_team_decides_for_an_image_as_for_the_scene(league: str, team: str, change: object) -> None:
    made = []
    for _ in range(2):
        teams = {"home": team, "away": team}
        match = Match(league, home=3, away=3, matches=60, seed=5, controllers=teams, senses="ideal")
        set_phase(match, 0)
        scatter(match, np.random.default_rng(2))
        match.balls["vx"], match.balls["vy"] = np.random.default_rng(3).normal(0.0, 0.5, (2, 60))
        match.rebuild()
        made.append(match)
    scene, image = made
    change(image)  # type: ignore[operator]
    scene.step()
    image.step()
    ours, theirs = numbers(scene.robots["command"]), numbers(image.robots["command"])
    if change is mirror:
        theirs = theirs * np.array([1.0 if name in EVEN else -1.0 for name in COMMAND.names or ()])
    else:
        theirs = theirs[:, np.r_[3:6, 0:3]]
    np.testing.assert_allclose(theirs, ours, atol=1e-9)


def test_names_are_parsed_and_checked() -> None:
    assert set(TEAMS) <= set(registered_teams())
    assert parse_team("chaser") == ("chaser", 1.0, {}) and parse_team("chaser@0.25") == ("chaser", 0.25, {})
    switches = {"recovery": False, "step_length": 0.04, "stuck_count": 9, "goal_force": "unit"}
    text = "sacks-2001@0.5:recovery=False,step_length=0.04,stuck_count=9,goal_force=unit"
    assert parse_team(text) == ("sacks-2001", 0.5, switches)
    assert make_team("chaser", strength=0.5).name == "chaser"
    changed: Any = make_team("sacks-2001:recovery=False", player_gain=0.4)
    assert changed.settings["recovery"] == 0 and changed.settings["player_gain"] == 0.4


@pytest.mark.parametrize(("name", "message"), [
    *((f"sacks-2001:{wrong}", "must be written as name=value") for wrong in ("", "x", "x=", "=1", "a=1,,b=2")),
    *((f"chaser@{wrong}", "must be a number from 0 to 1") for wrong in ("", "2", "-1", "x", "nan")),
    ("lions", "unknown team 'lions'.* known: "),
    ("chaser:recovery=False", "unknown setting of chaser 'recovery', did you mean .* known: settle"),
    ("sacks-2001:recover=False", "'recover' in SacksSettings, did you mean 'recovery' .*known: strength"),
    ("sacks-2001:recovery=3", "SacksSettings.recovery must be True or False, got 3"),
    ("x.zip:path=y", "the file of team 'x.zip' is given by its name, not by a setting path"),
])  # fmt: skip
def test_a_name_that_cannot_be_is_explained(name: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        make_team(name)


class Lions:
    """A team in Python, as another package ships it."""

    name, memory_dtype = "lions", np.dtype([])

    def __init__(self, strength: float, brave: bool) -> None:
        self.strength, self.brave = strength, brave

    def act(self, view: View, memory: np.ndarray, rng: TeamRandom) -> np.ndarray:
        return view.stand()


def lions(strength: float = 1.0, brave: bool = False) -> Lions:
    return Lions(strength, brave)


def nobody(brave: bool = False) -> Lions:
    return Lions(1.0, brave)


def nothing(strength: float = 1.0) -> None:
    return None


@pytest.fixture
def shipped(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let a package be installed that ships teams: lions, and some that are none."""
    names = {"lions": "lions", "nobody": "nobody", "nothing": "nothing"}
    points = [EntryPoint(name, f"{__name__}:{place}", ENTRY_POINTS) for name, place in names.items()]
    monkeypatch.setattr(registry, "entry_points", lambda group: points if group == ENTRY_POINTS else [])


@pytest.mark.usefixtures("shipped")
def test_a_package_ships_a_team_as_a_factory_of_its_strength_and_settings() -> None:
    assert "lions" in registered_teams()
    weak: Any = make_team("lions@0.5:brave=True")
    assert (weak.strength, weak.brave) == (0.5, True)
    also: Any = make_team("lions:strength=0.25,brave=True")
    assert (also.strength, also.brave) == (0.25, True)
    with pytest.raises(ValueError, match="team 'lions' has no setting 'teeth'; it has: strength, brave"):
        make_team("lions:teeth=3")
    Match(controllers={"home": "lions", "away": "lions@0"}, seed=1).step()


@pytest.mark.usefixtures("shipped")
@pytest.mark.parametrize(("name", "message"), [
    ("nobody", "team 'nobody' must be a function that takes strength=, .*:nobody is <function nobody"),
    ("nothing", "a team needs name, memory_dtype and act, got None"),
])  # fmt: skip
def test_an_entry_point_that_is_no_factory_of_a_team_is_refused(name: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        make_team(name)


def test_a_team_for_other_leagues_is_refused() -> None:
    still = make_team("still")
    assert isinstance(still, CompiledTeam)
    dogs = CompiledTeam("dogs", still.kernel, still.memory_dtype, still.settings, families=("legged",))
    Match("legged-2001", controllers={"home": dogs, "away": dogs}, seed=1)
    with pytest.raises(ValueError, match="'dogs' is for legged leagues, 'middle-size-2006' is"):
        Match("middle-size-2006", controllers={"home": dogs}, seed=1)


COUNT = np.dtype([("decisions", "i8")])
SUM = np.dtype([("players", "i8")])


@compiled
def count(belief, tracks, memory, noise, command, k, settings, scratch):  # type: ignore[no-untyped-def]
    """Count the decisions, say in which order the player came, and which settings and number it has."""
    memory.decisions += 1
    scratch.players += 1
    command.forward, command.left = settings.strength, scratch.players / 100.0
    command.turn, command.kick = belief.situation.number / 100.0, -1.0


@compiled
def walk(memory, noise, command, k, settings):  # type: ignore[no-untyped-def]
    command.forward = settings.strength


COUNTER, WALKER = per_player(count, SUM), per_blind_player(walk)


def counters(*strengths: float) -> CompiledTeam:
    return CompiledTeam("counters", COUNTER, COUNT, np.array([(one,) for one in strengths], STRENGTH))


@pytest.mark.parametrize(("league", "row"), list(zip(BASES, range(3), strict=True)))
def test_a_team_has_settings_for_each_kind_of_base_or_for_all(league: str, row: int) -> None:
    for strengths, expected in (((0.1, 0.2, 0.3), (0.1, 0.2, 0.3)[row]), ((0.4,), 0.4)):
        teams: dict[str, Any] = {"home": counters(*strengths), "away": "still"}
        match = Match(league, home=1, away=1, seed=1, controllers=teams, senses="ideal")
        match.step()
        assert match.robots["command"]["forward"][0, 0] == expected
