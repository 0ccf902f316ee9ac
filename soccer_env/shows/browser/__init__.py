"""A replay as one page for the browser: no network, no server, nothing but the file.

page.py      puts the parts together: markup, style, scripts and data, all of it escaped
collect.py   plays the replay and gathers what the page shows
events.py    goals, whistles and kicks, in words
packing.py   tables of numbers, small enough for a page
page.html    markup                     look.css    style, light and dark, for desks and phones
unpack.js    data out of the page       moment.js   what is true and believed at a time
fields.py    potential fields as bytes  forces.js   and as arrows
pitch.js     draws the field            overlays.js what robots believe, see and plan, over it
charts.js    time line, possession, ball position
panel.js     events, and the record of the robot that was picked
main.js      buttons, keys, the clock that runs
"""

from soccer_env.shows.browser.page import write_page

__all__ = ["write_page"]
