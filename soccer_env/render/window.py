"""A window that shows frames, in real time if asked."""

from __future__ import annotations

import os
import sys
import time
from typing import TYPE_CHECKING

import numpy as np

from soccer_env.render.canvas import require_pygame
from soccer_env.render.sheet import check_frame

if TYPE_CHECKING:
    import pygame


SEATS = ("DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR", "SDL_VIDEODRIVER")  # with a display, one of these is set
NO_DISPLAY = "there is no display to open a window on; soccer export makes a film, a picture or a page of a replay"
UNSEEN = ("offscreen", "dummy")  # fallbacks of SDL without a display


def check_display() -> None:
    """Raise ValueError if there is no display; a driver named by SDL_VIDEODRIVER is accepted unchecked."""
    require_pygame()
    if sys.platform.startswith("linux") and not any(map(os.environ.get, SEATS)):
        raise ValueError(NO_DISPLAY)  # before libraries of displays print their own errors
    import pygame

    try:
        pygame.display.init()
        driver = pygame.display.get_driver()
    except pygame.error as error:
        raise ValueError(f"there is no display to open a window on: {error}") from error
    if driver in UNSEEN and os.environ.get("SDL_VIDEODRIVER") != driver:
        pygame.display.quit()
        raise ValueError(NO_DISPLAY)


class Window:
    """A window that opens at the first frame; several can be open at once.

    `fps`: frames a second, None: as fast as they come. After the user closes the window (or presses Escape) `show`
    does nothing and returns False.
    """

    def __init__(self, caption: str = "soccer_env", fps: float | None = None) -> None:
        if fps is not None and not 0.0 < fps <= 1000.0:
            raise ValueError(f"fps must be above 0 and at most 1000, got {fps}")
        require_pygame()
        self.caption = caption
        self.fps = fps
        self.closed_by_user = False
        self._window: pygame.Window | None = None
        self._due = 0.0  # [s] of the performance counter: when the next frame may be shown
        self._pressed: list[str] = []
        self.held: set[str] = set()  # names of the keys that are held down in this window

    def pressed(self) -> list[str]:
        """Return the names of the keys that were pressed in this window since the last call, as pygame names them."""
        keys, self._pressed = self._pressed, []
        return keys

    def say(self, caption: str) -> None:
        """Change the caption of the window."""
        self.caption = caption
        if self._window is not None:
            self._window.title = caption

    @property
    def is_open(self) -> bool:
        """Tell whether a window is on the screen."""
        return self._window is not None

    def show(self, frame: np.ndarray) -> bool:
        """Show a frame (H, W, 3) uint8 when it is due; return False once the user has closed the window."""
        import pygame

        check_frame(frame)
        if self.closed_by_user:
            return False
        size = (frame.shape[1], frame.shape[0])
        image = pygame.image.frombuffer(np.ascontiguousarray(frame).tobytes(), size, "RGB")
        self._wait()
        try:
            self._flip(image)
        except pygame.error:  # someone called pygame.quit(), which ends all windows
            self._window = None
            self._flip(image)
        self._pump()
        return not self.closed_by_user

    def close(self) -> None:
        """Close the window; a later frame opens a new one unless the user closed it. Safe to repeat."""
        if self._window is not None:
            self._window.destroy()
            self._window = None
        self._due = 0.0
        self.held.clear()

    def _wait(self) -> None:
        """Sleep until the frame is due; a late frame shifts all later frames."""
        if self.fps is None:
            return
        now = time.perf_counter()
        if now < self._due:
            time.sleep(self._due - now)
        self._due = max(self._due, now) + 1.0 / self.fps

    def _flip(self, image: pygame.Surface) -> None:
        """Put the image into the window; open or resize the window if needed."""
        import pygame

        if self._window is None:
            pygame.display.init()
            self._window = pygame.Window(self.caption, image.get_size())
        elif self._window.size != image.get_size():
            self._window.size = image.get_size()
        self._window.get_surface().blit(image, (0, 0))
        self._window.flip()

    def _pump(self) -> None:
        """Handle the events of this window and leave the events of other windows in the queue."""
        import pygame

        keys = (pygame.KEYDOWN, pygame.KEYUP, pygame.WINDOWFOCUSLOST)
        for event in pygame.event.get((pygame.QUIT, pygame.WINDOWCLOSE, *keys)):
            escape = event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE
            mine = getattr(event, "window", None) is self._window
            if event.type == pygame.QUIT or (mine and (escape or event.type == pygame.WINDOWCLOSE)):
                self.closed_by_user = True
            elif mine:
                self._note_key(event)
            else:
                pygame.event.post(event)
        if self.closed_by_user:
            self.close()

    def _note_key(self, event: pygame.Event) -> None:
        """Note a key that goes down or up; a window that loses the focus hears no key go up."""
        import pygame

        if event.type == pygame.WINDOWFOCUSLOST:
            self.held.clear()
        elif event.type == pygame.KEYUP:
            self.held.discard(pygame.key.name(event.key))
        else:
            self._pressed.append(pygame.key.name(event.key))
            self.held.add(pygame.key.name(event.key))
