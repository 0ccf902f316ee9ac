"""The pictures of the pages, drawn from matches of fixed seeds: `make pictures`.

belief.py     the belief of one robot, drawn over the true state
drills.py     a sheet of the drills of each league
play.py       what a person sees who plays, by the truth and by a belief
frames.py     the field frame, the team frame and the robot frame on a pitch
rules.py      a sheet of the rules of a league, each staged and drawn in one frame
rules_legged.py  the situations of the legged league
rules_middle_size.py  the situations of the middle size
paper_figures.py  the figures of the two papers, a command each
legend.py     the strip of words under a picture
settings.py   sizes of the pictures, and the moments of the gallery
"""
