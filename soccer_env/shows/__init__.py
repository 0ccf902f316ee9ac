"""Replays shown: pictures, films and pages for the browser.

showing.py   `frame`, `video`, `html`: a picture, a film and a page of a replay
film.py      the control steps that a film shows, and their times       film_settings.py   the settings of a film
browser/     a replay as one page for the browser
"""

from soccer_env.shows.showing import frame, html, video

__all__ = ["frame", "html", "video"]
