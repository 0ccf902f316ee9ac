"""The reference: the public names, by task."""

from __future__ import annotations

import ast
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[3]
PUBLIC_OPTIONS = "    options:\n      inherited_members: true\n      show_root_full_path: false\n"


class Page(NamedTuple):
    """A page of the public reference."""

    name: str  # of its file
    title: str
    about: str
    things: tuple[str, ...]  # where each is defined, below soccer_env
    imported: str  # how


PUBLIC = (
    Page(
        "playing",
        "Play",
        "A match in arrays, and the environments of PettingZoo and Gymnasium around it.",
        (
            *("match.match.Match", "soccer_v0.parallel_env", "soccer_v0.env", "soccer_v0.raw_env"),
            *("soccer_v0.ParallelSoccer", "api.turn_env.TurnSoccer", "gymnasium_envs.SoloSoccer"),
            "api.gymnasium_vector.SoccerVectorEnv",
        ),
        "from soccer_env import Match, soccer_v0",
    ),
    Page(
        "records",
        "Records",
        "What `match.matches`, `balls`, `robots`, `events`, `percepts`, `beliefs` and `tracks` hold, field by field, "
        "and the codes in them.",
        ("types", "records.percepts", "records.beliefs"),
        "from soccer_env.types import Phase, Foul",
    ),
    Page(
        "observing",
        "Observe",
        "What a learner sees: the entries of a layout, an observation of your own, the whole truth.",
        (
            *("observations.layout", "observations.entry.Entry", "observations.entry.Observation"),
            "match.truth_state.WholeTruth",
        ),
        "from soccer_env import WholeTruth\nfrom soccer_env.observations import Entry, layout",
    ),
    Page(
        "rewarding",
        "Rewards and scenes",
        "What a learner is paid for, and how an episode begins and ends.",
        ("rewards.table.Rewards", "rewards.table.OwnTerm", "scenes.scene.Scene", "scenes.mixture.Mixture"),
        "from soccer_env import OwnTerm, Rewards, Scene\nfrom soccer_env.scenes import Mixture, mixture",
    ),
    Page(
        "teams",
        "Teams",
        "Teams by name, teams of your own, and several of them drawn by weights.",
        (
            *("teams.registry.make_team", "teams.lineup.Lineup", "teams.team.Team", "teams.team.View"),
            *("teams.team.TeamRandom", "teams.team.CompiledTeam", "teams.function_teams.team.team_of_function"),
        ),
        "from soccer_env import Lineup, Team, make_team, team_of_function",
    ),
    Page(
        "leagues",
        "Leagues",
        "Every number of a pitch, a ball, a kind of robot and a rule book.",
        (
            *("leagues.find_league", "leagues.league.League", "leagues.league.Pitch", "leagues.league.BallModel"),
            *("leagues.robot.Body", "leagues.robot.Drive", "leagues.robot.Head", "leagues.robot.Kicker"),
            *("leagues.robot.Block", "leagues.materials.Materials", "leagues.rules.Rules"),
        ),
        "from soccer_env import League\nfrom soccer_env.leagues import find_league",
    ),
    Page(
        "policies",
        "Policies",
        "From a network to a policy file that plays anywhere.",
        ("agents.torch_policy.save_policy", "agents.sb3_zip.convert_sb3", "agents.sb3_zip.load_sb3"),
        "from soccer_env.agents import convert_sb3, load_sb3, save_policy",
    ),
    Page(
        "evaluating",
        "Evaluate and train",
        "What `soccer evaluate`, `soccer tournament` and `soccer train` do, from Python.",
        (
            *("train.evaluate.evaluation.evaluate", "train.evaluate.settings.EvaluateSettings"),
            *("train.evaluate.results.EvaluationResult", "train.evaluate.results.Estimate"),
            *("train.tournament.playing.tournament", "train.tournament.settings.TournamentSettings"),
            *("train.tournament.results.TournamentResult", "train.tournament.results.Standing", "train.ppo.train"),
            *("train.ppo.settings.TrainSettings", "train.ppo.vec_env.SoccerVecEnv"),
        ),
        "from soccer_env.train.evaluate import EvaluateSettings, evaluate\n"
        "from soccer_env.train.tournament import TournamentSettings, tournament\n"
        "from soccer_env.train.ppo import SoccerVecEnv, TrainSettings, train",
    ),
    Page(
        "replays",
        "Replays, pictures and data",
        "Matches on disk that play again bit for bit, as pictures, films, pages and tables.",
        (
            *("replay.replay_file.Recorder", "replay.replay_file.Replay", "thoughts.thoughts.Thoughts"),
            *("render.frame.Picture", "render.overlays.onlooker.Onlooker", "data_out"),
            *("data_out.belief_errors.errors_of", "data_out.belief_errors.BeliefErrors"),
        ),
        "from soccer_env.replay import Recorder, Replay, Thoughts\nfrom soccer_env.render import Picture, save_png",
    ),
)


def first_line(file: Path) -> str:
    """Return the first line of a module's docstring."""
    text = ast.get_docstring(ast.parse(file.read_text(encoding="utf-8"))) or ""
    return text.partition("\n")[0]


def index_page() -> str:
    """Return the first page of the reference: the public names by what is done with them."""
    lines = ["# Reference", "", "What you call, by what you do. Fields, defaults and units stand in tables.", ""]
    lines += ["| page | what it is for | names |", "|---|---|---|"]
    for page in PUBLIC:
        names = ", ".join(f"`{thing.rpartition('.')[2]}`" for thing in page.things)
        lines.append(f"| [{page.title}]({page.name}.md) | {page.about} | {names} |")
    return "\n".join(lines) + "\n"


def public_page(page: Page) -> str:
    """Return a page of the public reference."""
    parts = [f"# {page.title}\n", f"{page.about}\n", f"```python\n{page.imported}\n```\n"]
    parts += [f"::: soccer_env.{thing}\n{PUBLIC_OPTIONS}" for thing in page.things]
    return "\n".join(parts)


def pages() -> dict[str, str]:
    """Return every page of the reference by its path."""
    return {"reference/index.md": index_page()} | {f"reference/{page.name}.md": public_page(page) for page in PUBLIC}


def navigation() -> list[object]:
    """Return the pages of the reference in order."""
    return [{"Public names": "reference/index.md"}, *({page.title: f"reference/{page.name}.md"} for page in PUBLIC)]
