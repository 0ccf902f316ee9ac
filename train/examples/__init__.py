"""Pages of at most 40 lines of code, each with another library: copy one and go on from there. Nothing imports them.

    python -m soccer_env.train.examples ppo_sb3 --steps 100000        make example-ppo_torchrl       make examples

A page says in its first lines what it needs, and what it reached in how long. One that needs more than the extra
`train` is run by make, in an environment of its own under build/examples/.

ppo_sb3.py          stable-baselines3 over `SoccerVecEnv`      ppo_supersuit.py    over PettingZoo, by SuperSuit
ppo_cleanrl.py      PPO in one file, straight on `Match`       mappo.py            MAPPO in one file, 5 v 5
cloning_minari.py   a Minari dataset of play, imitated         ppo_rllib.py        RLlib, with a worker
ppo_torchrl.py      a collector of TorchRL over PettingZoo     ppo_tianshou.py     Tianshou over the Gymnasium id
mappo_benchmarl.py  a task of BenchMARL, and its MAPPO         ippo_agilerl.py    AgileRL's IPPO, two processes
empty_goal.py       the task that most of them learn, and how well they learned it
monte_carlo.py      Monte Carlo search in branches of a match, which beats `chaser` in a drill
"""
