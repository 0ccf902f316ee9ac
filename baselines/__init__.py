"""Play scripted teams: simple ones, and those of the two papers.

    still.py         stands still                random.py        wanders about at random
    walker.py        walks straight ahead        chaser.py        plays, simply, in both leagues
    attacking.py     the chaser's attacker       goalkeeping.py   the chaser's goalkeeper
    obeying.py       the chaser and the rules    glancing.py      when it looks up to see where it is
    supporting.py    where its mates stand
    searching.py     the chaser without a ball   boards.py        the chaser and a ball in a corner
    carrying.py      the chaser with the ball    set_pieces.py    its restarts: pass, and leave the ball to others
    sacks_2001/      the legged team of Sacks (2001)
    heinemann_2006/  the middle-size team of Heinemann et al. (2006)
    weigel_2001/     the planner of the middle-size teams

What they share:

    sight.py         a belief, turned into the team frame once a decision
    skills.py        ways to move, to aim and to play the ball
    deciding.py      when a player decides, and how well by its strength
"""
