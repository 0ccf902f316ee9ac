"""The tables of the pages: measured by commands, stored as JSON, written between markers.

python -m soccer_env.train.pages.tables           measure all, or some by name       (make tables)
python -m soccer_env.train.pages.tables write     write the pages again from tables.json
python -m soccer_env.train.pages.tables --check   replay a small part of each        (make tables-check)
python -m soccer_env.train.pages.tables.sacks     every claim of Sacks 2001          (make sacks-table)
python -m soccer_env.train.pages.tables.heinemann every claim of Heinemann et al.    (make heinemann-table)

pages.py     measure the tables, and write them into the pages
drills.py    teams in drills
ladder.py    all teams of a league, rated
robustness.py    all teams under noise, delay, friction and faults
teams.py     teams against teams      learned.py   the learned team, and the time of its training
headlines.py the few figures of the main README, taken from the other tables
plausibility.py   statistics of play beside published figures of real matches
paper_page.py     the page of a team that was built from a paper
sacks.py          the page of sacks-2001
heinemann.py      the page of heinemann-2006 and weigel-2001
tables.json  the measured values
"""
