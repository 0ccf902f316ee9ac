"""What the APIs of a match share; the APIs themselves are `soccer_v0` (PettingZoo) and `gymnasium_envs`.

ids.py                the ids by which registries find the environments
infos.py              infos as flat numbers
report.py             nested infos in words, frames and windows, and checks of what callers pass
nested_arrays.py      nested infos of many matches
shown.py              what a console and a notebook show of an env
opponents.py          who the learners play against
turn_env.py           one agent after the other (AEC), and saves within a turn
gymnasium_vector.py   many matches as one Gymnasium VectorEnv
"""
