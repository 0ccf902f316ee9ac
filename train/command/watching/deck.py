"""The state that the keys of `soccer watch` set, such as pause and overlays; and the shots in order, with rewind."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import islice
from math import ceil

from soccer_env.match import Match
from soccer_env.render.captions import clock_words
from soccer_env.render.overlays.cast import Snapshot, take_snapshot
from soccer_env.render.overlays.flags import AT_BALL, OverlayFlags
from soccer_env.replay import Thoughts

SMOOTH = 50.0  # [1/s] frames shown, at most
IDLE = 30.0  # [1/s] checks of the keyboard during a pause
JUMP = 5.0  # [s] that the arrow keys jump
SLOWEST, FASTEST = 1 / 16, 100.0
OVERLAYS = {"b": "belief", "v": "sight", "x": "field", "w": "path", "o": "roles", "i": "infrared", "t": "trail"}
HELP = (
    "space: pause     , .: one step back, on",
    "left, right: 5 s back, on     home: to the start",
    "up, down: faster, slower",
    "r: next robot     e: whoever is at the ball",
    "f: follow that robot, the ball, nobody",
    "b: belief     v: what its camera sees",
    "x: potential field     w: planned, travelled way",
    "o: roles     i: infrared     t: trail of the ball",
    "h: these keys     escape: end",
)
FOLLOWS = ("", "robot", "ball")


KEPT = 6000  # shots in memory, some 16 kB each


class Tape:
    """The shots of a match, one for every `stride` control steps; the tape can rewind over the last KEPT shots."""

    def __init__(self, shots: Iterable[Snapshot], stride: int = 1) -> None:
        self._coming = iter(shots)
        self._stride = stride
        self.shots: list[Snapshot] = [next(self._coming)]
        self.at = 0
        self.ended = False

    def move_by(self, shots: int) -> None:
        """Move by a number of shots, backwards if negative, no further than either end."""
        self.at = max(0, self.at + shots)
        while self.at >= len(self.shots) and not self.ended:
            self._take()
        self.at = min(self.at, len(self.shots) - 1)

    def _take(self) -> None:
        """Append the next shot to the tape; drop the oldest shots beyond KEPT."""
        latest = None
        for shot in islice(self._coming, self._stride):
            latest = shot
        if latest is None:
            self.ended = True
            return
        self.shots.append(latest)
        if len(self.shots) > KEPT:
            del self.shots[: KEPT // 4]
            self.at -= KEPT // 4

    @property
    def shot(self) -> Snapshot:
        """Return the current shot."""
        return self.shots[self.at]

    def past(self, shots: int) -> list[Snapshot]:
        """Return at most `shots` shots before the current one."""
        return self.shots[max(0, self.at - shots) : self.at]


def play_live(match: Match, thoughts: Thoughts | None = None) -> Iterator[Snapshot]:
    """Play a match and yield a shot of its kick-off and of every control step until it ends.

    Robots' thoughts are noted at intervals, as in a replay: an overlay can be turned on at any moment.
    """
    step, note = 0, None
    while True:
        if thoughts is not None and thoughts.slots and step % thoughts.every == 0:
            note = thoughts.look(match)
        yield take_snapshot(match, note)
        if (match.terminated | match.truncated).all():
            return
        match.step()
        step += 1


class PlaybackControls:
    """The state that keys control; `rate`: tape shots per second of play; `agents`: robots that keys select."""

    def __init__(
        self, tape: Tape, rate: float, speed: float, flags: OverlayFlags | None = None, agents: tuple[str, ...] = (),
        follow: str = "",
    ) -> None:  # fmt: skip
        if not 0.0 < speed <= FASTEST:
            raise ValueError(f"speed must be above 0 and at most {FASTEST:g}, got {speed}")
        self.tape, self.rate, self.speed = tape, rate, speed
        self.flags, self.agents = flags or OverlayFlags(), agents
        self.follow = follow
        self.paused = self.helps = False

    def press(self, key: str) -> None:
        """Carry out the action of a key, or nothing for an unused key."""
        if key == "space":
            self.paused = not self.paused
        elif key in (",", "."):
            self.paused = True
            self.tape.move_by(1 if key == "." else -1)
        elif key in ("left", "right"):
            self.tape.move_by(round(JUMP * self.rate) * (1 if key == "right" else -1))
        elif key in ("up", "down"):
            faster = 2.0 if key == "up" else 0.5
            self.speed = min(max(self.speed * faster, SLOWEST), FASTEST)
        elif key == "home":
            self.tape.move_by(-self.tape.at)
        else:
            self._press_for_view(key)

    def _press_for_view(self, key: str) -> None:
        if key in OVERLAYS:
            self.flags = self.flags.turned(OVERLAYS[key])
        elif key in ("h", "?", "f1"):
            self.helps = not self.helps
        elif key == "f":
            self.follow = FOLLOWS[(FOLLOWS.index(self.follow) + 1) % len(FOLLOWS)]
        elif key == "e":
            self.flags = replace(self.flags, robot=AT_BALL)
        elif key == "r" and self.agents:
            at = self.agents.index(self.flags.robot) if self.flags.robot in self.agents else -1
            self.flags = replace(self.flags, robot=self.agents[(at + 1) % len(self.agents)])

    @property
    def skip(self) -> int:
        """Return how many shots to advance per frame, so that at most SMOOTH frames a second are shown."""
        return max(1, ceil(self.rate * self.speed / SMOOTH))

    @property
    def fps(self) -> float:
        """Return the frame rate of the window [1/s]."""
        return IDLE if self.paused else self.rate * self.speed / self.skip

    def words(self) -> str:
        """Return the caption of the window: the clock, and "paused", "end" or the speed."""
        state = "paused" if self.paused else "end" if self.over() else f"{self.speed:g}x"
        return f"soccer_env  {clock_words(self.tape.shot[0])}  {state}  (h: keys)"

    def over(self) -> bool:
        """Tell whether the last shot is on screen."""
        return self.tape.ended and self.tape.at == len(self.tape.shots) - 1
