"""Teams that play trained policies: networks, policy files and the bundled policies.

learned.py      a policy as a team
policy.py       a policy: a network, and the facts that must agree before it may play
normalising.py  normalisation of observations before a network
rules_known.py  the rules that a policy was trained under, and a warning under other rules
trained_with.py the senses that a policy was trained with, and differences from a match
array_checks.py checks of a policy's arrays
policy_file.py  policy files, which never run code
torch_policy.py policies of any torch library, written as policy files
torch_layers.py the layers of a torch module
sb3_zip.py      zips of stable-baselines3, read without running their contents
sb3_actor.py    the parameters of the actor in these zips
onnx_team.py    policies in ONNX files as teams
onnx_export.py  policies written as ONNX files
onnx_checks.py  checks of ONNX files: a network of known size
perceptron.py   the network, computed in compiled code
recurrent.py    a recurrent memory before the layers
policies/       the bundled policies, with their model card
"""

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.agents.onnx_export import save_onnx
    from soccer_env.agents.sb3_zip import convert_sb3, load_sb3
    from soccer_env.agents.torch_policy import save_policy

__all__ = ["convert_sb3", "load_sb3", "save_onnx", "save_policy"]
__getattr__, __dir__ = lazy_names(
    __name__,
    {"convert_sb3": "sb3_zip", "load_sb3": "sb3_zip", "save_onnx": "onnx_export", "save_policy": "torch_policy"},
)
