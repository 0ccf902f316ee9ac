"""The settings of a training: every bad value has a plain message, and a command says the same again."""

import shlex
import sys
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from soccer_env.agents.learned import BUNDLED
from soccer_env.rewards import NAMES, TERMS
from soccer_env.train.command.command_line import main
from soccer_env.train.command.parsing import read_settings
from soccer_env.train.ppo.checks import check_playable
from soccer_env.train.ppo.options import BOUNDS, PlainSettings
from soccer_env.train.ppo.settings import TrainSettings, command_of
from soccer_env.train.ppo.updating.update import minibatch_size
from soccer_env.train.written_settings import split_names
from tests.train.ppo.staged_training import tiny_settings

SHARES = ("learning_rate", "target_kl", "stage_share")
ABOVE_ZERO = ("minutes", "noise", "evaluate_minutes", "discount_half_life", "advantage_half_life")
COUNTS = ("threads", *(name for name, bounds in BOUNDS.items() if bounds.low == 1.0))
NAN, INFINITY = float("nan"), float("inf")


@pytest.mark.parametrize("name", [*ABOVE_ZERO, *SHARES])
@pytest.mark.parametrize("value", [NAN, INFINITY, -INFINITY, 0, 0.0, -1.0, "1", None, True, 10**400])
def test_what_is_not_above_0_is_refused(name: str, value: Any) -> None:
    with pytest.raises(ValueError, match=f"{name} must be a number above 0"):
        TrainSettings(**{name: value})


@pytest.mark.parametrize("name", NAMES)
def test_weights_may_be_0_and_not_less(name: str) -> None:
    assert getattr(TrainSettings(**{name: 0.0}), name) == 0.0
    for value in (NAN, INFINITY, -1e-9, "0", None):
        with pytest.raises(ValueError, match=f"{name} must be 0 to "):
            TrainSettings(**{name: value})


@pytest.mark.parametrize("name", SHARES)
def test_a_share_is_1_at_most(name: str) -> None:
    assert getattr(TrainSettings(**{name: 1.0}), name) == 1.0
    with pytest.raises(ValueError, match=f"{name} must be a number above 0 and at most 1, got 1.01"):
        TrainSettings(**{name: 1.01})


@pytest.mark.parametrize("name", [*COUNTS, "seed", "past", "critic_first"])
def test_a_count_is_a_whole_number(name: str) -> None:
    least = 1 if name in COUNTS else 0
    for value in (least - 1, 2.0, NAN, "2", None, True):
        allowed = rf"(a whole number of at least {least}|(a whole number, )?{least} to )"
        with pytest.raises(ValueError, match=f"{name} must be {allowed}"):
            TrainSettings(**{name: value})


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"mirror": True, "observe": "percepts"}, "mirror needs observe='belief' or 'truth'"),
        ({"observe": "truth"}, "observe='truth' needs senses='ideal'"),
        ({"observe": "x-rays"}, "observe must be one of belief, percepts, truth, got 'x-rays'"),
        ({"device": "tpu"}, "device must be one of auto, cpu, cuda"),
        ({"mirror": "yes"}, "mirror must be True or False, got 'yes'"),
        ({"name": 3}, "name must be a text, got 3"),
        ({"senses": "eyes"}, "senses must be one of ideal, sensors"),
        ({"out": 3}, "out must be a path"),
        ({"hidden": "x"}, "hidden must be one to six layer sizes"),
        ({"scenes": "kick-of"}, "unknown scene 'kick-of', did you mean 'kick-off'"),
        ({"scenes": "kick-off:a,scattered"}, "scenes must be written as NAME:share"),
        ({"critic": "8,8,8,8,8,8,8"}, "critic must be one to six layer sizes"),
        ({"players": "0v3"}, "players must be 1 to 11"),
        ({"players": "1v1,,2v2"}, "players must be names with commas"),
        ({"players": "1v1;2v2;3v3", "opponents": "still;chaser"}, "equally many stages, or one .* got 3 and 2"),
        ({"opponents": ""}, "opponents must be names with commas"),
        ({"opponents": "chaser,chaser"}, "opponents must be different"),
        ({"evaluate_matches": 3}, "evaluate_matches must be an even whole number, for each seed .*, got 3"),
        ({"minutes": 1e300}, "minutes must be a number above 0 and below 10000"),
        ({"seed": 2**32}, "seed must be 0 to 4294967295"),
        ({"batch": 1}, "a batch and a rollout must have 2 decisions at least"),
    ],
)
def test_a_setting_that_makes_no_sense_is_refused(changes: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        replace(TrainSettings(mirror=False), **changes)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"league": "moon"}, "unknown league 'moon'; known: legged-2001"),
        ({"opponents": "still,winners"}, "opponents: unknown team 'winners'"),
        ({"opponents": "none.safetensors"}, "opponents: policy file 'none.safetensors'"),
        ({"opponents": "sacks-2001", "league": "middle-size-2006"}, "is for legged leagues, 'middle-size-2006' is"),
        ({"rules": "leage"}, "unknown rules 'leage', did you mean 'league'"),
        ({"scenes": "kick-off,dribble-past-three"}, "away must be 3 to 3 in scene 'dribble-past-three'"),
        ({"start": "none.safetensors"}, "start: policy file 'none.safetensors'"),
        (
            {"start": str(BUNDLED), "action_repeat": 2},
            "start: .* is of another shape: actions is .skills., the run.s .box.",
        ),
        ({"matches": 1}, "matches must be at least one for each of 2 team sizes, got 1"),
        ({"action_repeat": 1001}, "action_repeat must be 1 to 1000, got 1001"),
        ({"name": "a|b"}, "name must be 1 to 64 characters"),
        ({"out": Path("x\x07y")}, "out must be a folder of the run's own with a plain name"),
        ({"out": Path()}, "out must be a folder of the run's own with a plain name"),
    ],
)
def test_what_cannot_be_played_is_found_before_a_folder_is_made(tmp_path: Path, changes: Any, message: str) -> None:
    from soccer_env.train.ppo import train

    with pytest.raises(ValueError, match=message):
        train(tiny_settings(**{"out": tmp_path / "run", **changes}))
    assert not list(tmp_path.iterdir())


def test_a_missing_gpu_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("torch.cuda.is_available", lambda: False)
    with pytest.raises(ValueError, match="device='cuda' needs a GPU"):
        check_playable(tiny_settings(tmp_path, device="cuda"))


def test_a_rollout_is_cut_into_nearly_equal_parts() -> None:
    asked = [(24576, 4096), (16448, 4096), (1000, 4096), (336, 20), (3, 2), (2, 2), (5, 2)]
    assert [minibatch_size(*one) for one in asked] == [4096, 4112, 1000, 20, 2, 2, 3]


def from_words(command: str) -> TrainSettings:
    words = shlex.split(command)
    assert words[:2] == ["soccer", "train"]
    return read_settings(TrainSettings, words[2:], "train", TrainSettings())


NUMBERS = st.floats(1e-12, 9999.0)
CHANGES: dict[str, st.SearchStrategy[Any]] = {
    **dict.fromkeys(ABOVE_ZERO, NUMBERS),
    **dict.fromkeys(("learning_rate", "noise"), st.floats(1e-12, 1.0)),
    **dict.fromkeys(NAMES, st.floats(0.0, 1e9)),
    **dict.fromkeys(SHARES, st.floats(1e-9, 1.0)),
    **dict.fromkeys(("steps", "batch", "epochs", "critic_first"), st.integers(2, 10**12)),
    **dict.fromkeys(("mirror", "central_critic"), st.booleans()),
    "start": st.sampled_from(["", "my policy.safetensors"]),
    "opponents": st.sampled_from(["still", "sacks-2001:pull=True,other=2,chaser", "a b.zip:observe=belief", "'\"$x"]),
    "name": st.sampled_from(["learned", "a b", "--mirror x"[2:]]),
    "pose": st.sampled_from(["particles", "percept"]),
    "activation": st.sampled_from(["tanh", "relu"]),
    "out": st.sampled_from([Path("a b"), Path("/tmp/it's")]),
    "players": st.sampled_from(["1v1", "1v1,2v2,3v5", "1v1;2v2,3v3"]),
    "senses": st.sampled_from(["ideal", "home=ideal,away=sensors"]),
}


@settings(max_examples=40)
@given(changes=st.fixed_dictionaries({}, optional=CHANGES))
def test_a_command_asks_for_the_same_settings(changes: dict[str, Any]) -> None:
    wanted = TrainSettings(**changes)
    assert from_words(command_of(wanted)) == wanted


def test_a_flag_may_say_what_is_the_default_and_names_keep_the_commas_of_their_switches() -> None:
    for word in ("--mirror", "--no-mirror"):
        name, value = word.replace("no-", "")[2:], "no-" not in word
        assert getattr(from_words(f"soccer train {word}"), name) is value
    assert split_names("chaser, sacks-2001:a=1,b=2,still", "x") == ("chaser", "sacks-2001:a=1,b=2", "still")


def test_every_setting_is_explained(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["train", "--help-all"])
    text = " ".join(capsys.readouterr().out.replace("│", " ").split())
    source = Path(sys.modules[PlainSettings.__module__].__file__ or "").read_text()
    for field in fields(TrainSettings):
        assert f"--{field.name.replace('_', '-')}" in text
        if field.name in NAMES:  # the weight of a reward
            assert TERMS[NAMES.index(field.name)].text in text
            continue
        after = source.split(f"\n    {field.name}: ", 1)[1].split("\n")[1].strip()
        assert after.startswith('"""') and len(after) > 12, f"{field.name} has no text"
        assert " ".join(after.strip('"').split()[:3]) in text, f"the text of {field.name} is not in the help"
