"""MAPPO in one file: two robots act by what they believe, and their common critic knows the state of the match.

Needs: torch==2.13.0
Reached: TODO s
"""

import torch
from torch.distributions import Normal
from torch.nn import Linear, Parameter, Sequential, Tanh

from soccer_env import Match
from soccer_env.train.examples.empty_goal import EMPTY_GOAL, share_scored
from soccer_env.train.examples.ppo_cleanrl import advantages


def main(steps: int = 800_000, seed: int = 1, gamma: float = 0.99, decay: float = 0.95, clip: float = 0.2) -> float:
    """Learn for `steps` decisions of robots, and return the share of episodes in which they score."""
    torch.manual_seed(seed)
    torch.set_num_threads(1)
    match = Match(**EMPTY_GOAL, home=2, observe="belief", matches=32, autoreset="same_step", seed=seed)
    sizes = (len(match.observation_names), 4), (len(match.state_names), 1)
    actor, critic = (Sequential(Linear(n, 64), Tanh(), Linear(64, 64), Tanh(), Linear(64, out)) for n, out in sizes)
    actor[-1].weight.data *= 0.01  # at first the robots stand still, but for the noise
    log_std = Parameter(torch.full((4,), -0.5))
    optimizer = torch.optim.Adam([*actor.parameters(), *critic.parameters(), log_std], lr=1e-3)
    for _ in range(-(-steps // (128 * 32 * 2))):
        rollout = []
        for _ in range(128):
            seen, state = torch.tensor(match.observations[:, :2]), torch.tensor(match.state("home"))
            act = torch.normal(actor(seen), log_std.exp().expand(32, 2, 4)).detach()
            last = act[:, :1]  # a row for the opponent, ignored
            _, paid, terminated, truncated = match.step(torch.cat([act, last], 1).clamp(-1, 1).numpy())
            after = match.state("home")
            if len(match.ended):  # these matches show a new episode, but the values belong to the ended one
                after[match.ended] = match.final.state("home")
            outcome = (paid[:, :2].mean(1, dtype="f4"), ~terminated, ~(terminated | truncated))
            rollout.append((seen, act, state, *map(torch.tensor, (after, *outcome))))
        seen, act, state, after, paid, more, going = (torch.stack(item) for item in zip(*rollout, strict=True))
        old, value = Normal(actor(seen), log_std.exp()).log_prob(act).detach(), critic(state)[..., 0].detach()
        gain = advantages(paid + gamma * more * critic(after)[..., 0].detach() - value, going, gamma * decay)
        for rows in torch.rand(10, 128).argsort(1).reshape(-1, 32):  # in each of 10 epochs 4 parts, of times
            ratio = (Normal(actor(seen[rows]), log_std.exp()).log_prob(act[rows]) - old[rows]).sum(-1).exp()
            better = ((gain[rows] - gain.mean()) / gain.std())[..., None]  # the same for both robots
            loss = -torch.min(ratio * better, ratio.clamp(1 - clip, 1 + clip) * better).mean()
            loss += 0.5 * (critic(state[rows])[..., 0] - (gain + value)[rows]).square().mean()
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
    return share_scored(lambda seen: actor(torch.as_tensor(seen)).detach().numpy(), home=2, observe="belief")
