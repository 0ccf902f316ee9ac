"""The pictures of the pages, drawn from matches of fixed seeds: `make pictures`.

belief.py     what one robot believes, drawn over what is true
frames.py     the field frame, the team frame and the robot frame on a pitch
rules.py      the rules of a league, a frame each
staged_rules.py  how such a situation is set up
rules_legged.py  the situations of the legged league
rules_middle_size.py  those of the middle size
legend.py     the strip of words under a picture
settings.py   what the pictures show, and the table of the moments in the gallery
"""
