"""Run the work of a command as tasks on a Ray cluster: `--ray` starts a local one, `--ray ADDRESS` joins another.

tasks.py     submit calls, and give their results in order
held.py      objects with a state, which outlive the worker that holds them
packing.py   the code that tasks need, as one zip named by its content
unpacking.py the task on a worker: unpack that code and import it
node.py      then: check versions, compile once a node, call
"""

from soccer_env.train.cluster.held import Held
from soccer_env.train.cluster.tasks import Tasks, Workers, open_workers

__all__ = ["Held", "Tasks", "Workers", "open_workers"]
