"""Examples of at most 40 lines of code, to copy and extend. Nothing imports them.

    python -m soccer_env.train.examples ppo_cleanrl                   make example-cloning_minari      make examples

The first lines of an example name its packages, its result and its time. Make runs an example that needs more than the
extra `train` in a virtual environment under build/examples/.

ppo_sb3.py          stable-baselines3 over `SoccerVecEnv`: a first win against `chaser`
ppo_rllib.py        PPO of RLlib over Gymnasium's vectors, with past selves among the opponents
ppo_cleanrl.py      PPO in one file, straight on `Match`
cloning_minari.py   a Minari dataset of play, imitated
empty_goal.py       the task that most of them learn, and its test
monte_carlo.py      Monte Carlo search in branches of a match, which beats `chaser` in a drill
"""
