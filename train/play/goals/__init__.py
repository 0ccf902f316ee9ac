"""Classify the goals of matches and draw the seconds before them: `python -m soccer_env.train.play goals`.

settings.py   what the command line asks for
watching.py   matches are played until enough goals have fallen; what is kept of each goal
table.py      how goals fell, as the statistics of play count them, and what came before
sheet.py      one goal as a sheet of frames, the last second in small steps
"""
