"""The ids of the environments: `gymnasium.make`, `gymnasium.make_vec` and PettingZoo's registry find them by these.

`soccer_env/Legged2001-1v1-v0` to `-6v6-v0` and `soccer_env/MiddleSize2006-1v1-v0` to `-6v6-v0`; `home=` and `away=`
give any other sizes. `import soccer_env` registers them, so nothing of the environments is imported here.
"""

from __future__ import annotations

import gymnasium
import pettingzoo

LEAGUES = {"Legged2001": "legged-2001", "MiddleSize2006": "middle-size-2006"}
SIZES = range(1, 7)  # robots a side of the registered ids


def register() -> None:
    """Register the ids with Gymnasium and with PettingZoo, where it has a registry; nothing is imported for it."""
    for name, league in LEAGUES.items():
        for size in SIZES:
            known_as = f"soccer_env/{name}-{size}v{size}-v0"
            if known_as not in gymnasium.registry:
                gymnasium.register(
                    known_as,
                    entry_point="soccer_env.gymnasium_envs:SoloSoccer",
                    vector_entry_point="soccer_env.api.gymnasium_vector:SoccerVectorEnv",
                    kwargs={"league": league, "home": size, "away": size},
                )
    if hasattr(pettingzoo, "register") and "soccer_env/soccer-v0" not in pettingzoo.parallel_registry:
        pettingzoo.register("parallel", "soccer_env/soccer-v0", "soccer_env.soccer_v0:parallel_env")
        pettingzoo.register("aec", "soccer_env/soccer-v0", "soccer_env.soccer_v0:env")
