"""A replay as one page for the browser: a single file, without network or server.

page.py      joins markup, style, scripts and data, all of it escaped
collect.py   plays the replay and collects the data of the page
events.py    goals, whistles and kicks, in words
page.html    markup                     look.css    style, light and dark, for desktops and phones
unpack.js    data out of the page       moment.js   truth and beliefs at a time
fields.py    potential fields as bytes, and tables of numbers as text
forces.js    potential fields as arrows
pitch.js     draws the field            overlays.js draws beliefs, percepts and plans over the field
charts.js    time line, possession, ball position
panel.js     events, and the record of the selected robot
main.js      buttons, keys, the running clock
"""

from soccer_env.shows.browser.page import write_page

__all__ = ["write_page"]
