"""Replays shown: pictures, films and pages for the browser.

showing.py   `frame`, `video`, `html`: a replay drawn, as a film, as a page
film.py      which control steps a film shows, and when
browser/     a replay as one page for the browser
"""

from soccer_env.shows.showing import frame, html, video

__all__ = ["frame", "html", "video"]
