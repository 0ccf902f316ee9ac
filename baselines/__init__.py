"""Scripted teams: simple ones, and those of the two papers.

    still.py         stands still
    walker.py        walks straight ahead
    random.py        wanders about at random
    chaser/          plays, simply, in both leagues
    sacks_2001/      the legged team of Sacks (2001)
    heinemann_2006/  the middle-size team of Heinemann et al. (2006)
    weigel_2001/     the planner of the middle-size teams

Their shared skills are in `soccer_env/skills/`.
"""
