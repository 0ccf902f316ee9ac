"""A match as datasets of kloppy (extra `data`): `kloppy_tracking` and `kloppy_events`.

Places are in metres from the centre spot, y to the left of x, on a pitch of the league's length and width; kloppy turns
them into its other coordinate systems: `dataset.transform(to_coordinate_system="kloppy")`. Systems that stretch places
between the lines of a human pitch (Opta, StatsBomb, Wyscout) do not work with a penalty area of 0.5 m.
"""

from datetime import timedelta
from typing import Any

import numpy as np

from soccer_env.data_out.collect import SHOOT_OUT, MatchRecording, collect_match
from soccer_env.data_out.events import NOBODY, Event
from soccer_env.replay import Replay
from soccer_env.types import AWAY, HOME

HOW = 'pip install "soccer_env[data]"'
SHOTS = {"goal": "GOAL", "saved": "SAVED", "blocked": "BLOCKED", "off_target": "OFF_TARGET", "own_goal": "OWN_GOAL"}


def require_kloppy() -> Any:
    """Return the module `kloppy.domain`; ImportError says what to install."""
    try:
        from kloppy import domain
    except ImportError as error:
        raise ImportError(f"kloppy is not installed: {HOW}") from error
    return domain


def kloppy_tracking(replay: Replay) -> Any:
    """Return the first match as a kloppy TrackingDataset in metres, a frame for each control step.

    ImportError if the extra `data` is missing.
    """
    domain, recording = require_kloppy(), collect_match(replay)
    about = KloppyMatch(recording, domain)
    robots, ball, owners, in_play = recording.robots, recording.ball, recording.owners(), recording.in_play
    speeds, ball_speeds = np.hypot(robots["vx"], robots["vy"]), np.hypot(ball[:, 2], ball[:, 3])
    frames = []
    for frame in range(len(recording)):
        present = np.flatnonzero(robots["active"][frame] == 1).tolist()
        frames.append(
            domain.Frame(
                frame_id=frame,
                **about.moment(frame, int(owners[frame]), bool(in_play[frame])),
                players_data={
                    about.players[row]: domain.PlayerData(
                        domain.Point(float(robots["x"][frame, row]), float(robots["y"][frame, row])),
                        speed=float(speeds[frame, row]),
                        other_data={"heading": float(robots["heading"][frame, row])},
                    )
                    for row in present
                },
                ball_coordinates=domain.Point3D(
                    float(ball[frame, 0]), float(ball[frame, 1]), recording.league.ball.radius
                ),
                ball_speed=float(ball_speeds[frame]),
                other_data={},
                statistics=[],
            )
        )
    return domain.TrackingDataset(records=frames, metadata=about.metadata(float(recording.league.control_rate)))


def kloppy_events(replay: Replay) -> Any:
    """Return the first match as a kloppy EventDataset: passes, shots, interceptions, saves, fouls, calls.

    A goal without a shot (carried or bumped in) is a shot with the result GOAL or OWN_GOAL, kloppy's form of a goal.
    """
    domain, recording = require_kloppy(), collect_match(replay)
    about = KloppyMatch(recording, domain)
    shot_in = {(event.end_frame, event.team) for event in recording.events if event.outcome == "goal"}
    events = [event for event in recording.events if event.kind != "goal" or (event.frame, event.team) not in shot_in]
    records = [about.event(event, number) for number, event in enumerate(events)]
    return domain.EventDataset(records=records, metadata=about.metadata(None))


class KloppyMatch:
    """Teams, players and periods of a match in kloppy's classes."""

    def __init__(self, recording: MatchRecording, domain: Any) -> None:
        self.recording, self.domain = recording, domain
        grounds = (domain.Ground.HOME, domain.Ground.AWAY)
        self.teams = [
            domain.Team(team_id=side, name=name, ground=ground)
            for side, name, ground in zip(("home", "away"), recording.teams, grounds, strict=True)
        ]
        positions = domain.PositionType
        self.players = [
            domain.Player(
                player_id=player.name, team=self.teams[player.side == "away"], jersey_no=player.number,
                name=player.name, starting=bool(recording.robots["active"][0, player.row] == 1),
                starting_position=positions.Goalkeeper if player.keeper else positions.Unknown,
            )
            for player in recording.players
        ]  # fmt: skip
        for side, team in zip(("home", "away"), self.teams, strict=True):
            team.players = [self.players[player.row] for player in recording.players if player.side == side]
        self.numbers = recording.periods
        self.starts: dict[int, int] = {}
        self.periods: dict[int, Any] = {}
        for number in np.unique(self.numbers).tolist():
            frames = np.flatnonzero(self.numbers == number)
            self.starts[number] = int(frames[0])
            start, end = (self.since_start(int(frames[at])) for at in (0, -1))
            self.periods[number] = domain.Period(id=number, start_timestamp=start, end_timestamp=end)

    def since_start(self, frame: int) -> timedelta:
        """Return the time from the start of the recording to a frame."""
        return timedelta(seconds=frame / self.recording.league.control_rate)

    def since_period(self, frame: int) -> timedelta:
        """Return the time of a frame since the start of its period."""
        return self.since_start(frame - self.starts[int(self.numbers[frame])])

    def team(self, team: int) -> Any:
        """Return the kloppy team of a side, None for nobody."""
        return self.teams[team] if team in (HOME, AWAY) else None

    def moment(self, frame: int, owner: int, in_play: bool) -> dict[str, Any]:
        """Return period, time and state of the ball at a frame."""
        state = self.domain.BallState
        return {
            "period": self.periods[int(self.numbers[frame])],
            "timestamp": self.since_period(frame),
            "ball_owning_team": self.team(owner),
            "ball_state": state.ALIVE if in_play else state.DEAD,
        }

    def metadata(self, rate: float | None) -> Any:
        """Return the metadata of a dataset; `rate`: frames a second of a tracking dataset."""
        domain, recording = self.domain, self.recording
        first = recording.match["home_direction"][0] > 0.0
        if recording.periods[0] not in (1, SHOOT_OUT):
            first = not first  # home attacked the other way in the first half
        pitch = recording.league.pitch
        dimensions = domain.MetricPitchDimensions(
            x_dim=domain.Dimension(-0.5 * pitch.length, 0.5 * pitch.length),
            y_dim=domain.Dimension(-0.5 * pitch.width, 0.5 * pitch.width),
            standardized=False, pitch_length=pitch.length, pitch_width=pitch.width,
        )  # fmt: skip
        system = domain.CustomCoordinateSystem(
            domain.Origin.CENTER, domain.VerticalOrientation.BOTTOM_TO_TOP, dimensions
        )
        home, away = recording.score[-1].tolist()
        return domain.Metadata(
            periods=list(self.periods.values()), teams=self.teams, coordinate_system=system,
            pitch_dimensions=dimensions, frame_rate=rate, game_id=recording.name,
            orientation=domain.Orientation.HOME_AWAY if first else domain.Orientation.AWAY_HOME,
            flags=domain.DatasetFlag.BALL_OWNING_TEAM | domain.DatasetFlag.BALL_STATE,
            provider=domain.Provider.OTHER, score=domain.Score(home=home, away=away),
        )  # fmt: skip

    def event(self, event: Event, number: int) -> Any:
        """Convert an event to kloppy's classes."""
        domain, build = self.domain, self.domain.EventFactory()
        common = {
            "event_id": f"{number}", "team": self.team(event.team), "player": self.player(event.row),
            "coordinates": domain.Point(event.x, event.y), "raw_event": event, "result": None, "qualifiers": None,
            **self.moment(event.frame, event.team, bool(self.recording.in_play[event.frame])),
        }  # fmt: skip
        end = domain.Point(event.end_x, event.end_y)
        if event.kind == "pass":
            well = event.outcome == "successful"
            result = domain.PassResult.COMPLETE if well else domain.PassResult.INCOMPLETE
            return build.build_pass(**{
                **common, "result": result, "receive_timestamp": self.since_period(event.end_frame),
                "receiver_player": self.player(event.receiver) if well else None, "receiver_coordinates": end,
            })  # fmt: skip
        if event.kind in ("shot", "goal"):
            outcome = "own_goal" if event.outcome == "own_goal" else "goal" if event.kind == "goal" else event.outcome
            end = end if event.end_frame != NOBODY else None
            result = domain.ShotResult(SHOTS[outcome])
            return build.build_shot(**{**common, "result": result, "result_coordinates": end})
        if event.kind == "interception":
            return build.build_interception(**{**common, "result": domain.InterceptionResult.SUCCESS})
        if event.kind == "save":
            save = domain.GoalkeeperQualifier(value=domain.GoalkeeperActionType.SAVE)
            return build.build_goalkeeper_event(**{**common, "qualifiers": [save]})
        if event.kind == "foul":
            return build.build_foul_committed(**common)
        return build.build_generic(**common, event_name=event.kind)

    def player(self, row: int) -> Any:
        """Return the kloppy player of a robot (row), None for nobody."""
        return self.players[row] if row != NOBODY else None
