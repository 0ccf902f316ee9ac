"""A match as tracking data of the German league (DFL, Sportec Solutions): one XML file, which kloppy reads.

    from kloppy import sportec
    dataset = sportec.load_tracking(meta_data="match.xml", raw_data="match.xml")

The file holds match information and positions, which the league splits into two files. The format has 25 frames a
second, numbered from 10,000 in the first half and from 100,000 in the second; each shows the control step nearest in
time. Places are in metres from the centre spot, y to the left of x, not turned, speeds (S) in km/h. Penalty shoot-outs
are left out. The format needs a date: every match begins at the arbitrary date KICK_OFF. A robot that is sent off has
no frames. BallPossession is 1 home, 2 guest, 0 nobody or both; kloppy reads 0 as guest, `kloppy_tracking` does not.
"""

from collections.abc import Iterator
from datetime import timedelta
from math import hypot
from pathlib import Path
from xml.sax.saxutils import quoteattr

import numpy as np

from soccer_env.data_out.collect import MatchRecording, Player
from soccer_env.data_out.standard import KICK_OFF
from soccer_env.guards.whole_files import write_atomically
from soccer_env.types import AWAY, HOME

RATE = 25  # [1/s] frames, fixed by the format
SECTIONS = {1: ("firstHalf", 10_000), 2: ("secondHalf", 100_000)}  # by period: name, and number of the first frame
ROLES = {"home": "home", "away": "guest"}
KEEPER, PLAYER = "TW", "ZO"  # positions: goalkeeper, and all others: no code means "field player"
OWNER = {HOME: 1, AWAY: 2, -1: 0}  # BallPossession
KMH = 3.6  # the format's S is a speed in km/h


def write_sportec(recording: MatchRecording, path: Path) -> Path:
    """Write a match as one XML file."""
    write_atomically(path, "\n".join(xml_lines(recording)) + "\n")
    return path


def xml_lines(recording: MatchRecording) -> Iterator[str]:
    """Yield the XML file line by line."""
    chosen = {period: frames_of_period(recording, period) for period in SECTIONS}
    yield '<?xml version="1.0" encoding="UTF-8"?>'
    yield "<PutDataRequest>"
    yield from match_information(recording, chosen)
    yield "<Positions>"
    for period, frames in chosen.items():
        if len(frames):
            yield from ball_elements(recording, period, frames)
            for player in recording.players:
                yield from player_elements(recording, period, frames, player)
    yield "</Positions>"
    yield "</PutDataRequest>"


def frames_of_period(recording: MatchRecording, period: int) -> np.ndarray:
    """Return the indices of the recorded frames that the file shows of a period, 25 a second."""
    inside = np.flatnonzero(recording.periods == period)
    if not len(inside):
        return inside
    rate = recording.league.control_rate
    count = (len(inside) - 1) * RATE // rate + 1
    return np.asarray(np.rint(np.arange(count) * rate / RATE).astype(np.int64).clip(0, len(inside) - 1) + inside[0])


def opening_tag(name: str, closed: bool = True, **attributes: object) -> str:
    """Return the opening tag of an element with escaped attributes; closed: an empty element."""
    written = "".join(f" {key}={quoteattr(printable(str(value)))}" for key, value in attributes.items())
    return f"<{name}{written}{'/' if closed else ''}>"


def printable(text: str) -> str:
    """Return a text without the control characters that XML cannot hold."""
    return "".join(letter if letter.isprintable() else " " for letter in text)


def match_information(recording: MatchRecording, chosen: dict[int, np.ndarray]) -> Iterator[str]:
    """Yield the XML elements of teams, players, pitch and duration of the match."""
    pitch, (home, away) = recording.league.pitch, recording.score[-1].tolist()
    yield "<MatchInformation>"
    yield opening_tag(
        "General", MatchId=recording.name, KickoffTime=KICK_OFF.isoformat(), MatchDay=1, Result=f"{home}:{away}",
        HomeTeamName=recording.teams[0], GuestTeamName=recording.teams[1],
    )  # fmt: skip
    yield opening_tag("Environment", PitchX=pitch.length, PitchY=pitch.width)
    lasted = {period: max(0, len(frames) - 1) * 1000 // RATE for period, frames in chosen.items()}  # [ms]
    yield opening_tag("OtherGameInformation", TotalTimeFirstHalf=lasted[1], TotalTimeSecondHalf=lasted[2])
    yield "<Teams>"
    for side, team in zip(("home", "away"), recording.teams, strict=True):
        yield opening_tag("Team", closed=False, TeamId=side, TeamName=team, Role=ROLES[side], LineUp="")
        yield "<TrainerStaff/>"
        yield "<Players>"
        for player in recording.players:
            if player.side == side:
                yield opening_tag(
                    "Player", PersonId=player.name, ShirtNumber=player.number, Shortname=player.name,
                    FirstName=side, LastName=player.number, Starting="true",
                    PlayingPosition=KEEPER if player.keeper else PLAYER,
                )  # fmt: skip
        yield "</Players>"
        yield "</Team>"
    yield "</Teams>"
    yield "</MatchInformation>"


def date_and_time(recording: MatchRecording, frame: int) -> str:
    """Return the date and time of a frame of the recording as text."""
    return (KICK_OFF + timedelta(seconds=frame / recording.league.control_rate)).isoformat(timespec="milliseconds")


def ball_elements(recording: MatchRecording, period: int, frames: np.ndarray) -> Iterator[str]:
    """Yield the XML elements of the ball's frames."""
    section, first = SECTIONS[period]
    in_play, owners, radius = recording.in_play, recording.owners(), recording.league.ball.radius
    yield opening_tag(
        "FrameSet", closed=False, GameSection=section, MatchId=recording.name, TeamId="BALL", PersonId="BALL"
    )
    for number, frame in enumerate(frames.tolist(), first):
        status, owner = int(in_play[frame]), OWNER[int(owners[frame])]
        moved = motion_attributes(*recording.ball[frame].tolist())
        yield (
            f'<Frame N="{number}" T="{date_and_time(recording, frame)}" {moved} Z="{radius:g}" BallStatus="{status}" '
            f'BallPossession="{owner}"/>'
        )
    yield "</FrameSet>"


def player_elements(recording: MatchRecording, period: int, frames: np.ndarray, player: Player) -> Iterator[str]:
    """Yield the XML elements of a robot's frames while the robot is on the pitch."""
    section, first = SECTIONS[period]
    robots, row = recording.robots, player.row
    yield opening_tag(
        "FrameSet", closed=False, GameSection=section, MatchId=recording.name, TeamId=player.side, PersonId=player.name
    )
    x, y, vx, vy, active = (robots[name][:, row].tolist() for name in ("x", "y", "vx", "vy", "active"))
    for number, frame in enumerate(frames.tolist(), first):
        if active[frame] == 1:
            moved = motion_attributes(x[frame], y[frame], vx[frame], vy[frame])
            yield f'<Frame N="{number}" T="{date_and_time(recording, frame)}" {moved}/>'
    yield "</FrameSet>"


def motion_attributes(x: float, y: float, vx: float, vy: float) -> str:
    """Return the XML attributes for a place [m] and for the speed of a velocity [m/s]."""
    return f'X="{x:.4f}" Y="{y:.4f}" S="{KMH * hypot(vx, vy):.3f}"'
