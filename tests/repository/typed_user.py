"""What a user writes, for mypy in `make lint`: public names have their types, and each wrong setting is refused."""

from typing_extensions import assert_type

from soccer_env import Match, soccer_v0


def use() -> None:
    """Never run: an ignored error that does not come is itself an error of `mypy --strict`."""
    assert_type(Match("legged-2001", home=2, senses="ideal"), Match)
    assert_type(soccer_v0.parallel_env(home=1), soccer_v0.ParallelSoccer)
    Match(homee=2)  # type: ignore[call-arg]
    Match(home="two")  # type: ignore[arg-type]
    Match(senses="sensor")  # type: ignore[arg-type]
    Match(observe="thruth")  # type: ignore[arg-type]
    Match(rewards="sprase")  # type: ignore[arg-type]
    soccer_v0.parallel_env(render_modes="human")  # type: ignore[call-arg]
    soccer_v0.parallel_env(render_mode="humn")  # type: ignore[arg-type]
    soccer_v0.parallel_env(infos="flatt")  # type: ignore[arg-type]
