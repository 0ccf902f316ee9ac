"""The tables of the pages: measured by commands, kept as JSON, written between markers.

python -m soccer_env.train.pages.tables           measure all, or some by name       (make tables)
python -m soccer_env.train.pages.tables write     write the pages again from tables.json
python -m soccer_env.train.pages.tables --check   replay a small part of each        (make tables-check)
python -m soccer_env.train.pages.tables.sacks     every claim of Sacks 2001          (make sacks-table)
python -m soccer_env.train.pages.tables.heinemann every claim of Heinemann et al.    (make heinemann-table)

pages.py     which tables there are, and their way into the pages
markers.py   where in a page a table stands
drills.py    teams at drills
teams.py     teams against teams      learned.py   the learned team, and how long its training takes
crosstable.py     a row for each setting, a column for each opponent
headlines.py the few figures of the main README, picked out of the others
plausibility.py   how teams play beside what is published of real matches
claims.py    what `soccer reproduce` measures
paper_page.py     how the page of a team that was built from a paper is made
sacks.py          that of sacks-2001                sacks_settings.py  what it says of its settings
heinemann.py      that of heinemann-2006 and weigel-2001
tables.json  what was measured
"""
