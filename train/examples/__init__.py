"""Examples of at most 40 lines of code, each with another library, to copy and extend. Nothing imports them.

    python -m soccer_env.train.examples ppo_sb3 --steps 100000        make example-ppo_torchrl       make examples

The first lines of an example name its packages, its result and its time. Make runs an example that needs more than the
extra `train` in a virtual environment under build/examples/.

ppo_sb3.py          stable-baselines3 over `SoccerVecEnv`      ppo_supersuit.py    over PettingZoo, by SuperSuit
ppo_cleanrl.py      PPO in one file, straight on `Match`       mappo.py            MAPPO in one file, 5 v 5
cloning_minari.py   a Minari dataset of play, imitated         ppo_rllib.py        RLlib, with a worker
ppo_torchrl.py      a collector of TorchRL over PettingZoo     ppo_tianshou.py     Tianshou over the Gymnasium id
mappo_benchmarl.py  a task of BenchMARL, and its MAPPO         ippo_agilerl.py    AgileRL's IPPO, two processes
empty_goal.py       the task that most of them learn, and its test
monte_carlo.py      Monte Carlo search in branches of a match, which beats `chaser` in a drill
"""
