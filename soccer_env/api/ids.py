"""The ids of the environments for `gymnasium.make`, `gymnasium.make_vec` and PettingZoo's registry.

`soccer_env/Legged2001-1v1-v0` to `-6v6-v0` and `soccer_env/MiddleSize2006-1v1-v0` to `-6v6-v0`; `home=` and `away=`
set any other sizes. Episodes are truncated after `STEPS` steps, or `max_cycles=`, so that a learner sees returns;
episodes of `soccer_env/Legged2001-Match-1v1-v0` and so on are whole matches. PettingZoo knows `soccer_env/soccer-v0`
and `soccer_env/soccer-Match-v0`.

`import soccer_env` registers the ids, so this file imports no environment. A worker process that has not imported the
package uses `soccer_env:soccer_env/Legged2001-1v1-v0`: Gymnasium imports the module before the colon.
"""

import gymnasium
import pettingzoo

LEAGUES = {"Legged2001": "legged-2001", "MiddleSize2006": "middle-size-2006"}
SIZES = range(1, 7)  # robots a side of the registered ids
STEPS = 1000  # of an episode: a minute of the legged league, 20 s of the middle size
LENGTHS: dict[str, int | None] = {"": STEPS, "Match-": None}  # word in an id -> steps of an episode


def register() -> None:
    """Register the ids with Gymnasium, and with PettingZoo if it has a registry, without importing environments."""
    for word, steps in LENGTHS.items():
        for name, league in LEAGUES.items():
            for size in SIZES:
                known_as = f"soccer_env/{name}-{word}{size}v{size}-v0"
                if known_as not in gymnasium.registry:
                    gymnasium.register(
                        known_as,
                        entry_point="soccer_env.gymnasium_envs:SoloSoccer",
                        vector_entry_point="soccer_env.api.gymnasium_vector:SoccerVectorEnv",
                        kwargs={"league": league, "home": size, "away": size, "max_cycles": steps},
                    )
        known_as = f"soccer_env/soccer-{word}v0"
        if hasattr(pettingzoo, "register") and known_as not in pettingzoo.parallel_registry:
            pettingzoo.register("parallel", known_as, "soccer_env.soccer_v0:parallel_env", max_cycles=steps)
            pettingzoo.register("aec", known_as, "soccer_env.soccer_v0:env", max_cycles=steps)
