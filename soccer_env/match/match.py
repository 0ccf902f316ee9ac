"""Match: M matches side by side, with `reset` and `step` on arrays instead of dicts.

    decide -> act -> sense -> tell -> believe -> observe
              drive, physics, referee, restart, rewards

The records are public arrays (see `types`): `match.balls["x"]` is (M,), `match.robots["heading"]` (M, R). One match
is M = 1; match m of many is bit for bit the match that runs alone with its seed.
"""

from collections.abc import Iterable
from functools import partial
from typing import Any

import numpy as np

from soccer_env.actions import actions_to_numbers, write_learner_commands
from soccer_env.guards.workers import Workers
from soccer_env.match import truth_state
from soccer_env.match.arguments import MatchArguments, init_takes_fields_of
from soccer_env.match.batch import ActionSums, MatchBatch
from soccer_env.match.saving import Branching, guard_match_methods
from soccer_env.match.senses import sensing_sides
from soccer_env.match.settings import make_settings
from soccer_env.match.skill_players import SkillPlayers
from soccer_env.match.squads import TeamArrays, assign_teams, choose_teams, make_squads, run_compiled, run_python
from soccer_env.match.user_code import UserObservations, UserRewardTerms
from soccer_env.match.views import Views, final_records
from soccer_env.observations import layout
from soccer_env.physics.engine.space_batch import Backend
from soccer_env.random_numbers import check_seeds, seeds_for
from soccer_env.rewards import NAMES
from soccer_env.teams.function_teams.asking import forbid_changes

Transition = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]
BLOCK = 64  # matches whose stages run one after the other, so that their Spaces stay in the cache; measured
NOBODY = np.zeros(0, np.int64)


@guard_match_methods
class Match(Views, Branching):
    """M matches of one league, simulated side by side and stepped together.

    `help(Match.__init__)` explains the settings, which are the fields of `MatchArguments`; ValueError names the wrong
    setting and the allowed values. M matches, R robots (home first), n numbers in an observation:

    | attribute | shape | what it holds |
    |---|---|---|
    | `observations` | (M, R, n) | what learners observe, named by `observation_names`; or your own observations |
    | `rewards`, `terms` | (M, R), (M, R, terms) | rewards of the last step, and the share of each of `term_names` |
    | `terminated`, `truncated` | (M,), (M,) | how episodes have ended; with "same_step" `step` returns it |
    | `ended` | (E,) | with "same_step": rows that began anew in the last step, in order; else empty |
    | `final` | by name | end of those episodes: "observations" (E, R, n), "state", records; row i: match `ended[i]` |
    | `matches`, `balls`, `robots` | (M,), (M,), (M, R) | the truth; and `percepts`, `beliefs`, `tracks` |
    | `events`, `robot_events` | (M,), (M, R) | what happened in the last control step |
    | `statistics` | (M,) | counts of play since the episode began; `soccer list statistics` defines the figures |
    | `agents` | R names | the robot of each row: "home_0" and so on |
    | `learns` | (R,) | 1: actions steer the robot; 0: its team plays it, and its row of actions is ignored |
    | `seeds` | (M,) | seed of each match: `Match(seeds=[match.seeds[17]])` is match 17 alone |
    | `settings`, `league` | | every setting resolved, such as `settings.rewards.gamma`; the numbers of the league |

    Set `learns` of a team's robot to 1 between two steps to take it over: its team goes on deciding, unheard, until 0.
    """

    @init_takes_fields_of(MatchArguments)
    def __init__(self, arguments: MatchArguments) -> None:
        self.arguments = arguments
        self.count, self.threads, self.autoreset = arguments.matches, arguments.threads, arguments.autoreset
        self.settings = make_settings(arguments)
        self.league = self.settings.league
        self.agents = self.settings.agents
        self.state_names = [entry.name for entry in self.state_entries()]
        self.term_names = [*NAMES, *self.settings.rewards.extra]
        self.seen, self._own_terms = UserObservations(self.settings, self.count), UserRewardTerms(self.settings.rewards)
        entries = {group.side: layout(self.league, group.observe) for group in self.seen.groups}
        names = {side: [entry.name for entry in side_entries] for side, side_entries in entries.items()}
        self.observation_entries: Any = entries if self.seen.by_side else entries[""]
        self.observation_names: Any = names if self.seen.by_side else names[""]  # by "home" and "away" if they differ
        self._make_arrays(arguments.backend)
        self._make_squads(
            assign_teams(
                self.agents, self.settings.home, arguments.opponents, arguments.teammates, arguments.controllers
            )
        )
        self._pool = Workers(self.threads) if self.count >= 2 * self.threads > 2 else None
        self.recorder: Any = None  # a replay.Recorder, while one writes this match down
        self.seeds = np.zeros(self.count, np.uint64)
        self.ended, self.final = NOBODY, truth_state.FinalRecords(self.settings)  # see _restart_same_step
        self.started = self._stepped = False  # the last reset or step was completed; a first step was made
        self.reset(seed=arguments.seed, seeds=arguments.seeds)
        self.batch.build_spaces([0])  # changes nothing, but compiles the kernels that later resets need

    def _make_arrays(self, backend: Backend | None) -> None:
        """Allocate the arrays and set them as attributes of the Match."""
        observed = 0 if self.seen.own else len(self.observation_names)
        self.batch = batch = MatchBatch(self.settings, self.count, len(self.agents), observed, backend)
        self.matches, self.balls, self.robots = batch.matches, batch.balls, batch.robots
        self.events, self.robot_events = batch.events, batch.robot_events
        self.rewards, self.terms = batch.rewards, batch.terms
        self.terminated, self.truncated = batch.terminated, batch.truncated
        self.statistics = batch.statistics
        self.observations: Any = self.seen.arrays if self.seen.own else batch.observations

    def _make_squads(self, who: dict[str, Any]) -> None:
        """Make a squad for each team, with its memory, and the sensors of the sides that need them."""
        self._use_squads(make_squads(self.agents, who, self.settings, self.count))
        self.learns = np.array([agent not in who for agent in self.agents], np.int64)
        sides = sensing_sides(self.settings, self.squads, self.learns)
        if sides:
            self.batch.use_sensors(sides)
        batch, robots = self.batch, self.robots
        self._team_arrays = TeamArrays(batch.beliefs, batch.tracks, robots["noise"], robots["command"], batch.constants)
        chosen = self.settings.actions.name == "skills"
        self.skills = SkillPlayers(self.league, self._team_arrays) if chosen else None
        unplayed = self.count if not self.learns.any() else 0  # with learners there are always actions
        self._no_actions = np.zeros((unplayed, len(self.agents), self.settings.actions.size))

    # Starting

    def reset(self, seed: int | None = None, seeds: Any = None) -> np.ndarray:
        """Begin new episodes in all matches; return observations (M, R, n).

        A seed, or seeds (M,), restarts the random streams of the matches; without, each match goes on to its next
        episode. The very first reset without a seed draws a seed from the system.
        """
        if seed is not None and seeds is not None:
            raise ValueError("give seed or seeds, not both")
        fresh = seed is not None or seeds is not None or not self.started
        new_seeds = (
            check_seeds(seeds, self.count) if seeds is not None else seeds_for(seed, self.count) if fresh else None
        )
        self.started = False
        if new_seeds is not None:
            self.seeds[:] = new_seeds
        self._begin(range(self.count), np.zeros(self.count, np.int64) if fresh else self.matches["episode"] + 1)
        self.rewards[:] = 0.0
        self.terms[:] = 0.0
        self.started = True
        observations: np.ndarray = self.observations
        return observations

    def _begin(self, rows: Iterable[int], episodes: np.ndarray) -> None:
        """Begin new episodes, numbered `episodes`, in the matches `rows`, and write their observations."""
        self._take_up_added_teams()
        for m in rows:
            self.batch.start(int(m), int(self.seeds[m]), int(episodes[m]))
            for squad in self.squads:
                squad.memory[m] = np.zeros((), squad.memory.dtype)
            if self.skills is not None:
                self.skills.begin(int(m))
            choose_teams(self.squads, self.settings.rows[0], int(m), int(self.seeds[m]), int(episodes[m]))
            self.batch.sense_first_frame(m)
        self._observe_own()
        if self.recorder is not None:
            self.recorder.note_rebuild(rows)

    # Stepping

    def step(self, actions: Any = None, *, last: bool = True) -> Transition:
        """Advance all matches by `action_repeat` control steps.

        actions: (M, R, 4 or 7) in [-1, 1] for all robots (rows that teams play are ignored), indices (M, R) or
        (M, R, 4), or None if teams play all robots. Returns observations (M, R, n) float32, rewards (M, R), terminated
        (M,) and truncated (M,): the match's own arrays, valid until the next step. ValueError for actions of a wrong
        shape or not finite. With autoreset "off" a match that is over stands still, one cut off by a limit goes on.
        last=False: the action goes on in the next call; shaping discounts once, in the call that ends the action.
        """
        numbers = self._check_actions(actions)
        self.started = False  # until the end
        transition = self._play_action(numbers, last)
        self.started = self._stepped = True
        return transition

    def _play_action(self, numbers: np.ndarray, last: bool) -> Transition:
        """Play the control steps of one action, and begin new episodes where one has ended."""
        mode, repeat = self.autoreset, self.settings.action_repeat
        ended: Any = ()
        if mode == "next_step" and self._has_ended():
            ended = np.flatnonzero(self.terminated | self.truncated)
        sums = ActionSums(self.batch) if repeat > 1 else None
        for left in reversed(range(repeat)):  # a match that is over waits
            self.batch.discount(last and left == 0)
            self._control_step(numbers)
            if sums is not None:
                sums.add()
        if sums is not None:
            sums.replace_last_step()
        if mode == "same_step":
            return self._restart_same_step()
        if len(ended):
            self._restart_next_step(ended)
        elif self._has_ended():
            for m in np.flatnonzero(self.matches["over"]).tolist():  # observations at rest hold the commands too
                self.batch.observe_anew(m, m + 1)
        return self.observations, self.rewards, self.terminated, self.truncated

    def _check_actions(self, actions: Any) -> np.ndarray:
        """Return the actions as numbers; ValueError names the first agent whose action is wrong or missing."""
        if actions is not None:
            return actions_to_numbers(self.settings.actions, actions, self.agents, self.learns, self.count)
        if self.learns.any():
            agent = self.agents[int(np.argmax(self.learns))]
            raise ValueError(f"actions are missing for {agent}: no team plays it")
        return self._no_actions

    def _control_step(self, numbers: np.ndarray) -> None:
        """Run one control step: users' Python before, compiled slices of matches, users' Python after."""
        self._own_terms.begin(self)
        self._decide_python_teams()
        if self.recorder is not None:  # the recorder notes all commands before any robot moves
            self._decide_slice(numbers, 0, self.count)
            self.recorder.note_commands(self.robots["command"])
        if self._pool is None or not self._stepped:  # the first step may compile: threads cannot be interrupted then
            self._step_slice(numbers, 0, self.count)
        else:
            edges = [self.count * i // self.threads for i in range(self.threads + 1)]
            self._pool.map(partial(self._step_slice, numbers), edges[:-1], edges[1:])
        self._own_terms.pay(self)
        self._observe_own()
        if self.recorder is not None:
            self.recorder.note_state(self)

    def _step_slice(self, numbers: np.ndarray, first: int, last: int) -> None:
        """Run one control step of a slice of matches, a block of matches at a time."""
        batch = self.batch
        for start in range(first, last, BLOCK):
            stop = min(start + BLOCK, last)
            if self.recorder is None:
                self._decide_slice(numbers, start, stop)  # commands of learners and teams
            batch.act(start, stop)  # drive, physics, referee, restart, rewards
            batch.sense(start, stop)  # percepts
            batch.tell(start, stop)  # how the match stands
            batch.believe(start, stop)  # beliefs and tracks
            batch.observe(start, stop)  # observations of the learners

    def _decide_slice(self, numbers: np.ndarray, first: int, last: int) -> None:
        """Write the commands of a slice of matches: decisions of compiled teams, and over them learners' actions."""
        if len(self._readers):
            self.batch.read(self._readers, first, last)
        for squad in self.squads:
            if squad.compiled:
                run_compiled(squad, self._team_arrays, self.batch.write_observations, first, last)
        if self.skills is None:
            write_learner_commands(self.robots, numbers, first, last, self.learns)
        else:
            self.skills.write_commands(numbers, self.learns, first, last)

    def _decide_python_teams(self) -> None:
        """Let teams written in plain Python decide, in all matches at once."""
        for squad in self.squads:
            if not squad.compiled:
                self.batch.read(squad.players, 0, self.count)
                with forbid_changes(self, squad.team.name):
                    run_python(squad, self.league, self.batch.beliefs, self.batch.tracks, self.robots)

    def _observe_own(self) -> None:
        """Fill the observations that the user's own code computes."""
        if self.seen.own:
            self.seen.fill(self)

    # Starting again

    def _restart_next_step(self, ended: np.ndarray) -> None:
        """Begin new episodes in the matches that ended before this step; their reward in this step is 0."""
        self._begin(ended, self.matches["episode"] + 1)
        self.rewards[ended] = 0.0
        self.terms[ended] = 0.0

    def _restart_same_step(self) -> Transition:
        """Begin new episodes in matches that just ended; set `ended` to their rows, `final` to their last state."""
        if not self._has_ended():
            self.ended = NOBODY
            return self.observations, self.rewards, self.terminated, self.truncated
        terminated, truncated = self.terminated.copy(), self.truncated.copy()
        self.ended = np.flatnonzero(terminated | truncated)
        self.final = final_records(self)
        self._begin(self.ended, self.matches["episode"] + 1)
        return self.observations, self.rewards, terminated, truncated

    def _has_ended(self) -> bool:
        """Tell whether the episode of any match has ended."""
        return bool(np.count_nonzero(self.terminated) or np.count_nonzero(self.truncated))

    def close(self) -> None:
        """End the worker threads of this Match."""
        if self._pool is not None:
            self._pool.shutdown()
