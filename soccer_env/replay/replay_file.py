"""Replay files: a saved state, the commands of every robot, and a log of rebuilds.

A replay repeats commands, so it needs neither teams nor policies. Its log holds each rebuild of the physics (by a save
or load) and the records of each new episode; a hash of the play per control step proves that it plays again exactly.
"""

from __future__ import annotations

import io
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np

from soccer_env.guards.checking import short_repr
from soccer_env.guards.whole_files import read_regular_file, write_atomically
from soccer_env.leagues.league import League
from soccer_env.match import Match, saving
from soccer_env.match.arguments import REPLAYED, version
from soccer_env.replay.checks import FORMAT, LARGEST, check_format, check_room, check_size, check_start
from soccer_env.replay.parts import numbers_to_records, rebuild_settings, records_to_numbers, replay_settings
from soccer_env.scenes import Scene
from soccer_env.thoughts.thoughts import Notes, Thoughts
from soccer_env.types import COMMAND, GAZE, WORLD


class Recorder:
    """Records a running match, whose physics is rebuilt at the start, as by a save.

    With `thoughts` the replay also keeps percepts, beliefs and decisions, for `soccer export` to show.
    """

    def __init__(self, match: Match, thoughts: Thoughts | None = None) -> None:
        check_room(match.count, len(match.agents))
        if callable(match.settings.scene.success) and match.settings.episode == "drill":
            raise ValueError("a drill that a function of your own ends cannot be recorded: replays hold no code")
        match.recorder = None
        self.start = saving.dump(match, memory=False)
        match.rebuild()
        self.settings = match.settings
        self.commands: list[np.ndarray] = []
        self.gazes: list[np.ndarray] = []
        self.hashes: list[str] = []
        self.log: list[tuple[int, list[int], bytes]] = []  # (control steps before it, matches, their records)
        self.thoughts = thoughts
        self._match = match
        match.recorder = self

    def __repr__(self) -> str:
        return f"<Recorder of {self._match!r}: {len(self.commands)} control steps>"

    def note_commands(self, commands: np.ndarray) -> None:
        """Note the commands (M, R) of a control step, and the gazes of heads that move by themselves."""
        self.commands.append(commands.copy())
        self.gazes.append(self._match.robots["gaze"].copy())

    def note_state(self, match: Match) -> None:
        """Note the hash of the play after a control step."""
        self.hashes.append(saving.play_hash(match))
        if self.thoughts is not None:
            self.thoughts.note(match, len(self.hashes))

    def note_rebuild(self, rows: Any) -> None:
        """Note a rebuild of the physics of some matches, and their records: by a save, a load or a new episode."""
        which = np.array(rows, int)
        self.log.append((len(self.commands), which.tolist(), saving.dump(self._match, memory=False, rows=which)))

    def length(self) -> tuple[int, int, int]:
        """Return the numbers of recorded commands, hashes and rebuilds."""
        return len(self.commands), len(self.hashes), len(self.log)

    def cut(self, length: tuple[int, int, int]) -> None:
        """Drop everything recorded after that `length`."""
        commands, hashes, log = length
        del self.commands[commands:], self.gazes[commands:], self.hashes[hashes:], self.log[log:]
        if self.thoughts is not None:
            self.thoughts.cut(hashes)

    def stop(self) -> Replay:
        """Stop recording and return the replay."""
        self._match.recorder = None
        commands = np.array(self.commands) if self.commands else np.zeros((0, *self._match.robots.shape), COMMAND)
        gazes = np.array(self.gazes) if self.gazes else np.zeros(commands.shape, GAZE)
        settings = replay_settings(self._match)
        thoughts = {} if self.thoughts is None else self.thoughts.packed()
        return Replay(settings, self.start, commands, gazes, list(self.hashes), list(self.log), version(), thoughts)


class Replay:
    """A recorded match: `play` runs it again, `write` and `read` keep it in a file."""

    def __init__(
        self, settings: dict[str, Any], start: bytes, commands: np.ndarray, gazes: np.ndarray, hashes: list[str],
        log: list[tuple[int, list[int], bytes]], made_by: str = "", thoughts: dict[str, np.ndarray] | None = None,
    ) -> None:  # fmt: skip
        self.thoughts = thoughts or {}  # the result of `Thoughts.packed`; {}: thoughts were not noted
        self.made_by = made_by  # the version of soccer_env that recorded the match; "" in old files
        self.settings, self.start, self.hashes, self.log = settings, start, hashes, log
        self.commands, self.gazes = commands, gazes

    def __len__(self) -> int:
        return len(self.commands)

    def __repr__(self) -> str:
        names = (short_repr(name)[1:-1] for name in self.teams)  # of an untrusted file
        return f"<Replay of {' against '.join(names)}: {len(self)} control steps>"

    @property
    def teams(self) -> tuple[str, str]:
        """Return the teams home and away; "learner" for robots that no team played."""
        players, sides = self.settings.get("teams") if isinstance(self.settings, dict) else None, []
        known = players if isinstance(players, dict) else {}
        for side in ("home", "away"):
            names = [str(name) for agent, name in known.items() if agent.startswith(side)]
            sides.append(" + ".join(dict.fromkeys(names)) or "learner")
        return sides[0], sides[1]

    def notes(self) -> Notes | None:
        """Return the thoughts of the robots; None if they were not recorded, ValueError if they are damaged."""
        if not self.thoughts:
            return None
        try:
            return Notes(self.thoughts, self.commands.shape[2])
        except (KeyError, TypeError, RecursionError, OverflowError) as error:
            raise ValueError(f"the thoughts of this replay are damaged: {error!r}") from error

    def make_match(self) -> Match:
        """Return the match at the start of the recording, with all robots played by actions."""
        settings = self.settings
        try:
            scene = settings["scene"]
            wanted = {name: settings[name] for name in (*REPLAYED, "matches")}
            wanted["variation"] = settings.get("variation")  # older replays have none
            wanted["league"] = rebuild_settings(League, settings["league"])
            wanted["scene"] = Scene(scene["name"], "replayed", None, scene["success"], float(scene["time_limit"]))
            check_start(self.start, wanted)
            match = Match(actions="full", seed=0, **wanted)
        except (KeyError, TypeError, AttributeError, OverflowError) as error:
            raise ValueError(f"the settings of this replay are damaged: {error!r}") from error
        saving.restore(match, self.start, memory=False)
        match.rebuild()
        return match

    def play(self) -> Iterator[Match]:
        """Yield the match at its start and after every control step; ValueError names the first step that differs."""
        match = self.make_match()
        yield match
        pending = list(self.log)
        for step in range(len(self.commands) + 1):
            while pending and pending[0][0] == step:
                _, rows, records = pending.pop(0)
                if not all(0 <= m < match.count for m in rows) or len(set(rows)) < len(rows):
                    raise ValueError(f"this replay is damaged: it rebuilds matches {rows} of {match.count}")
                saving.restore(match, records, memory=False, rows=np.array(rows, int))
                match.rebuild(rows)
            if step == len(self.commands):
                return
            match.robots["gaze"] = self.gazes[step]
            match.step(records_to_numbers(self.commands[step]))
            if saving.play_hash(match) != self.hashes[step]:
                raise ValueError(f"this replay differs from the recorded match at control step {step}{self._other()}")
            yield match

    def check(self) -> int:
        """Play everything again; return the number of control steps. ValueError names the first that differs."""
        return sum(1 for _ in self.play()) - 1

    def _other(self) -> str:
        """Return a note for the error if another version recorded the match, else ""."""
        other = self.made_by not in ("", version())
        return f"; soccer_env {self.made_by} recorded it, and this is {version()}" if other else ""

    def write(self, path: str | Path) -> Path:
        """Write the replay to a file, whole or not at all; return its path."""
        path = Path(path)
        log = [[step, rows] for step, rows, _ in self.log]
        header = {"format": FORMAT, "world": WORLD, "version": self.made_by, "settings": self.settings, "log": log}
        arrays = {
            "header": np.frombuffer(json.dumps(header).encode(), np.uint8),
            "start": np.frombuffer(self.start, np.uint8),
            "commands": records_to_numbers(self.commands),
            "gazes": records_to_numbers(self.gazes),
            "hashes": np.array(self.hashes, "S32"),
            **{f"records_{index}": np.frombuffer(entry[2], np.uint8) for index, entry in enumerate(self.log)},
            **self.thoughts,
        }
        content = io.BytesIO()
        np.savez_compressed(content, **arrays)  # type: ignore[arg-type]  # numpy's stubs take them for allow_pickle
        write_atomically(path, content.getvalue())
        return path

    @staticmethod
    def read(path: str | Path) -> Replay:
        """Read a replay file; ValueError if it is damaged or no replay. Nothing in the file is executed."""
        try:
            content = io.BytesIO(read_regular_file(path, LARGEST))
            check_size(content)
            with np.load(content, allow_pickle=False) as file:
                arrays = {name: file[name] for name in file.files}
            if "header" not in arrays:
                raise ValueError("it is an archive of something else")
            header = json.loads(arrays["header"].tobytes())
            check_format(header)
            log = [
                (int(step), [int(m) for m in rows], arrays[f"records_{index}"].tobytes())
                for index, (step, rows) in enumerate(header["log"])
            ]
            hashes = [value.decode() for value in arrays["hashes"]]
            commands = numbers_to_records(arrays["commands"], COMMAND, "commands")
            gazes = numbers_to_records(arrays["gazes"], GAZE, "gazes")
            if commands.shape != gazes.shape:
                raise ValueError(f"it has commands of shape {commands.shape} and gazes of {gazes.shape}")
            if len(commands) != len(hashes):
                raise ValueError(f"it has {len(commands)} commands and {len(hashes)} hashes")
            made_by = str(header.get("version", ""))[:40]
            thoughts = {name: arrays[name] for name in ("thoughts", "thoughts_about") if name in arrays}
            start = arrays["start"].tobytes()
            return Replay(header["settings"], start, commands, gazes, hashes, log, made_by, thoughts)
        except FileNotFoundError:
            raise
        except BadZipFile as error:
            raise ValueError(
                f"{path} is not a replay that can be read: it is cut short, damaged or no replay"
            ) from error
        except Exception as error:  # zipfile, zlib, tokenize, ...: a damaged file can raise almost anything
            raise ValueError(f"{path} is not a replay that can be read: {error}") from error
