"""Tasks on a cluster of two nodes with a core each: the results of a local run, whatever dies meanwhile."""

import os
import signal
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from soccer_env.train.cluster import Tasks, tasks
from soccer_env.train.evaluate import EvaluateSettings, evaluate, evaluate_drills
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.settings import ReproduceSettings
from soccer_env.train.ppo import training
from soccer_env.train.ppo.updating.matches import SharedMatches
from soccer_env.train.tournament import TournamentSettings, tournament
from tests.train.cluster import victims
from tests.train.cluster.victims import Victim
from tests.train.ppo.staged_training import outcome, tiny_settings, train_plainly, whole_run

ray = pytest.importorskip("ray")
pytestmark = pytest.mark.slow
SHORT: dict[str, Any] = {"matches": 4, "minutes": 0.1, "players": 1, "senses": "ideal"}


class Nodes:
    """A cluster of this machine: the node of this process, and another one."""

    def __init__(self) -> None:
        from ray.cluster_utils import Cluster

        self.cluster = Cluster(initialize_head=True, head_node_args=self.core)
        self.address = self.cluster.address
        tasks.connect(self.address)  # before there is another node, which would do as well for this process
        self.add_other()

    core = {"num_cpus": 1, "object_store_memory": 100 << 20, "include_dashboard": False}

    def add_other(self) -> None:
        """Start the other node."""
        self.other = self.cluster.add_node(**self.core)
        self.cluster.wait_for_nodes()  # also until one that was killed is missed

    def kill_other(self) -> None:
        """Kill the other node without a farewell."""
        self.cluster.remove_node(self.other, allow_graceful=False)


@pytest.fixture(scope="module")
def nodes() -> Iterator[Nodes]:
    """Return the cluster; every test joins it by its address."""
    nodes = Nodes()
    yield nodes
    ray.shutdown()
    nodes.cluster.shutdown()


def after_death(folder: Path, kill: Callable[[int], None]) -> threading.Thread:
    """Start a thread that kills the victim, by its pid, once it waits in the folder."""

    def wait_and_kill() -> None:
        while not (folder / "pid").exists():
            time.sleep(0.05)
        kill(int((folder / "pid").read_text()))

    thread = threading.Thread(target=wait_and_kill, daemon=True)
    thread.start()
    return thread


def kill_process(pid: int) -> None:
    os.kill(pid, signal.SIGKILL)


def files_of(folder: Path) -> dict[str, bytes]:
    """Return the result and the lines of all matches below a folder, byte for byte."""
    paths = [*folder.rglob("matches.jsonl"), *folder.rglob("result.json")]
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}


@pytest.mark.parametrize("cores", [2, 5])
def test_an_evaluation_on_any_number_of_cores_writes_the_bytes_of_a_local_one(
    nodes: Nodes, tmp_path: Path, cores: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Tasks, "cores", cores)
    for name, ray in (("here", None), ("there", nodes.address)):
        evaluate(EvaluateSettings(home="chaser", away="learned", ray=ray, out=tmp_path / name, **SHORT))
    assert files_of(tmp_path / "here") == files_of(tmp_path / "there") != {}


@pytest.mark.parametrize("dying", ["worker", "node"])
def test_the_death_of_a_worker_or_a_node_changes_no_byte(nodes: Nodes, tmp_path: Path, dying: str) -> None:
    settings = EvaluateSettings(home="victim", away="still", out=tmp_path / "here", **SHORT)
    evaluate(settings, teams={"victim": Victim(tmp_path)})
    there = EvaluateSettings(home="victim", away="still", out=tmp_path / "there", ray=nodes.address, **SHORT)
    thread = after_death(tmp_path, kill_process if dying == "worker" else lambda pid: nodes.kill_other())
    evaluate(there, teams={"victim": Victim(tmp_path, nodes.other.node_id)})
    thread.join(timeout=victims.LONG)
    assert (tmp_path / "pid").exists() and not thread.is_alive()
    if dying == "node":
        nodes.add_other()
    assert files_of(tmp_path / "here") == files_of(tmp_path / "there")


def test_a_tournament_with_a_worker_killed_midway_writes_the_bytes_of_a_local_one(nodes: Nodes, tmp_path: Path) -> None:
    teams = "chaser,still,victim"
    tournament(TournamentSettings(teams=teams, out=tmp_path / "here", **SHORT), teams={"victim": Victim(tmp_path)})
    after_death(tmp_path, kill_process)
    victim = Victim(tmp_path, nodes.other.node_id)
    tournament(
        TournamentSettings(teams=teams, out=tmp_path / "there", ray=nodes.address, **SHORT), teams={"victim": victim}
    )
    assert (tmp_path / "pid").exists()
    assert files_of(tmp_path / "here") == files_of(tmp_path / "there")


def test_claims_and_drills_on_a_cluster_have_the_results_of_local_ones(nodes: Nodes, tmp_path: Path) -> None:
    for name, ray in (("here", None), ("there", nodes.address)):
        reproduce(ReproduceSettings(claims=("S15", "S20"), quick=True, seeds=(1,), ray=ray, out=tmp_path / name))
    here, there = ((tmp_path / name / "results.json").read_bytes() for name in ("here", "there"))
    assert here == there
    drill = {"scene": "empty-goal", "home": "chaser,still", "matches": 4}
    assert evaluate_drills(EvaluateSettings(**drill)) == evaluate_drills(EvaluateSettings(**drill, ray=nodes.address))


@pytest.mark.parametrize(("dying", "checkpoints"), [("worker", 1e-9), ("node", 1e9)])  # none or each rollout
def test_a_training_whose_workers_die_goes_on_to_the_files_of_a_local_one(
    nodes: Nodes, tmp_path: Path, tmp_path_factory: Any, dying: str, checkpoints: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    steps, step = [0], SharedMatches.step_async

    def count(matches: SharedMatches, actions: Any) -> None:
        step(matches, actions)
        steps[0] += 1
        if steps[0] == 30 and dying == "worker":
            kill_process(ray.get(matches._held[1]._actor.__ray_call__.remote(lambda actor: os.getpid())))
        elif steps[0] == 30:
            nodes.kill_other()
        elif steps[0] == 40:
            raise KeyboardInterrupt

    monkeypatch.setattr(training, "CHECKPOINT_SHARE", checkpoints)
    monkeypatch.setattr(SharedMatches, "step_async", count)
    with pytest.raises(KeyboardInterrupt):
        train_plainly(tiny_settings(tmp_path, ray=nodes.address))
    if dying == "node":
        nodes.add_other()
    train_plainly(tiny_settings(tmp_path, ray=nodes.address if dying == "worker" else None))
    assert outcome(tmp_path) == outcome(whole_run(tmp_path_factory))
    assert (steps[0] > 40) == (dying == "worker")


def test_ctrl_c_keeps_finished_matches_and_cancels_the_others(nodes: Nodes, tmp_path: Path) -> None:
    settings = EvaluateSettings(home="victim", away="still", out=tmp_path / "run", ray=nodes.address, **SHORT)
    team = Victim(tmp_path, nodes.other.node_id)
    after_death(tmp_path, lambda pid: signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT))
    with pytest.raises(KeyboardInterrupt):
        evaluate(settings, teams={"victim": team})
    waits_until(lambda: not is_alive(int((tmp_path / "pid").read_text())))
    evaluate(settings, teams={"victim": team})
    assert len((tmp_path / "run" / "matches.jsonl").read_text().splitlines()) == 4


def is_alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return "\nState:\tZ" not in Path(f"/proc/{pid}/status").read_text()


def waits_until(done: Callable[[], bool]) -> None:
    end = time.monotonic() + 20.0
    while not done():
        assert time.monotonic() < end
        time.sleep(0.05)


def test_results_come_in_order_and_each_node_prepares_once(nodes: Nodes, tmp_path: Path) -> None:
    with Tasks(nodes.address) as there:
        assert there.cores == 2
        calls = [(number, 1) for number in range(8)]
        assert list(there.submit(pow, calls, prepare=(victims.note, (tmp_path,)))) == [*range(8)]
    assert (tmp_path / "notes").read_text() == "here\n"  # both nodes are this machine


def test_workers_import_the_code_that_was_sent(nodes: Nodes) -> None:
    with Tasks(nodes.address) as there:
        (file,) = there.submit(victims.say_where, [()])
    assert Path(file).parts[-4:-2] == ("code", there._digest)


def test_an_error_in_a_task_is_raised_here_and_a_task_that_kills_its_workers_is_given_up(
    nodes: Nodes, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tasks, "TRIES", 1)
    with Tasks(nodes.address) as there:
        with pytest.raises(ValueError, match="invalid literal"):
            list(there.submit(int, [("1",), ("one",)]))
        with pytest.raises(ConnectionError, match="given up after 2 tries"):
            list(there.submit(victims.end_process, [()]))


def test_a_node_with_other_versions_is_refused(nodes: Nodes, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tasks, "play_facts", lambda: {"numba": "0.1"})
    with Tasks(nodes.address) as there, pytest.raises(ValueError, match=r"cannot play the same .* 0\.1 here"):
        list(there.submit(pow, [(1, 1)]))


def test_another_cluster_is_refused(nodes: Nodes) -> None:
    with pytest.raises(ValueError, match=f"belongs to the cluster at {nodes.address}, not to 10.0.0.1:6379"):
        Tasks("10.0.0.1:6379")
