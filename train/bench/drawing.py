"""How long a picture of a match takes, plain and with what a robot believes, sees and plans over it."""

from __future__ import annotations

from time import process_time

from soccer_env.match import Match

WIDTH = 960  # [px]
TEAMS = {"legged-2001": "sacks-2001", "middle-size-2006": "heinemann-2006"}
OVERLAYS = "belief,trail,roles"


class PictureLoad:
    """A match of a team against itself, drawn after every control step."""

    def __init__(self, league: str, seed: int) -> None:
        from soccer_env.render import Picture
        from soccer_env.render.overlays.onlooker import Onlooker

        team = TEAMS[league]
        self.match = Match(league, controllers={"home": team, "away": team}, seed=seed, autoreset="same_step")
        self.picture, self.onlooker = Picture(league, WIDTH), Onlooker(self.match, OVERLAYS)
        self.sample(2, True)

    def sample(self, frames: int, overlays: bool) -> list[float]:
        """Return the seconds of the processor, which one thread takes, for each of so many frames."""
        spent, match = [], self.match
        for _ in range(frames):
            match.step()
            start = process_time()
            over = self.onlooker.see(match, WIDTH) if overlays else []
            self.picture.draw(match.matches[0], match.balls[0], match.robots[0], overlays=over)
            spent.append(process_time() - start)
        return spent
