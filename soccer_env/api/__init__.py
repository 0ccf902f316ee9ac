"""Parts that the APIs of a match share; the APIs themselves are `soccer_v0` (PettingZoo) and `gymnasium_envs`.

ids.py                the ids of the environments in the registries
infos.py              infos as flat numbers
report.py             nested infos in words, frames and windows, and checks of arguments
nested_arrays.py      nested infos of many matches
shown.py              text and picture of an env for consoles and notebooks
opponents.py          the opponents of the learners
turn_env.py           one agent after the other (AEC), and saves within a turn
gymnasium_vector.py   many matches as one Gymnasium VectorEnv
"""
