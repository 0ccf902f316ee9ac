"""The state that keys control in `soccer watch`: pause, speed, overlays, the robot or ball to follow."""

from dataclasses import replace
from math import ceil

from soccer_env.render.captions import clock_words
from soccer_env.render.overlays.flags import AT_BALL, OverlayFlags
from soccer_env.train.command.watching.tape import Tape

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


class PlaybackControls:
    """The state that keys control; `rate`: tape shots per second of play; `agents`: robots that keys select."""

    def __init__(
        self,
        tape: Tape,
        rate: float,
        speed: float,
        flags: OverlayFlags | None = None,
        agents: tuple[str, ...] = (),
        follow: str = "",
    ) -> None:
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
