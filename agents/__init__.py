"""Play learned teams: networks, policy files and the bundled policies.

learned.py      a policy as a team
policy.py       what a policy is: a network and all that has to agree before it may play
normalising.py  how observations are normalised before a network sees them
rules_known.py  the rules it was trained under, and a warning where it plays under others
trained_with.py the senses it was trained with, and how those of a match differ
policy_file.py  policy files, which never run code
torch_policy.py policies of any library on torch, written as such files
torch_layers.py what stands in a torch module
sb3_zip.py      zips of stable-baselines3, read without running what is in them
sb3_actor.py    which of their parameters are the actor
onnx_team.py    policies in ONNX files as teams
onnx_checks.py  what such a file may hold: a network of known size
perceptron.py   the network, computed in compiled code
attention.py    attention over other players, before its layers
policies/       the bundled policies, with their page
"""

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.agents.sb3_zip import convert_sb3, load_sb3
    from soccer_env.agents.torch_policy import save_policy

__all__ = ["convert_sb3", "load_sb3", "save_policy"]
__getattr__, __dir__ = lazy_names(
    __name__,
    {
        "convert_sb3": "soccer_env.agents.sb3_zip",
        "load_sb3": "soccer_env.agents.sb3_zip",
        "save_policy": "soccer_env.agents.torch_policy",
    },
)
