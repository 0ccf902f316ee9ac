"""Functions that only compiled ones call become machine code inside those alone, and whole when Python calls them."""

import gc

import numpy as np
import pytest

from soccer_env.compiled import compiled, config, inlined
from soccer_env.compiling.inner import is_inner

pytestmark = pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")


@compiled
def least(x):
    if x < 0.0:
        raise ValueError("below nothing")
    return np.sqrt(x)


@inlined
def half(x):
    return 0.5 * x


@compiled
def middle(x):
    return least(half(x)) + 1.0


@compiled
def outer(x):
    return 2.0 * middle(x)


@compiled
def beside(x):
    return 3.0 * middle(x)


@pytest.fixture(autouse=True)
def afresh(monkeypatch, tmp_path):
    monkeypatch.setattr("soccer_env.compiling.cache.cache_folders", lambda: (tmp_path / "cache",))
    for function in (least, half, middle, outer, beside):
        function._make_finalizer()()
        function._reset_overloads()
        function._cache_hits.clear()
        function._cache_misses.clear()


def kinds(function):
    return [is_inner(result) for result in function.overloads.values()]


def test_what_only_compiled_functions_call_has_no_machine_code():
    assert outer(8.0) == 6.0
    assert [kinds(function) for function in (outer, middle, least, half)] == [[False], [True], [True], [True]]


def test_a_function_that_python_calls_later_becomes_whole_and_others_still_find_it():
    assert outer(8.0) == 6.0
    assert middle(8.0) == 3.0 and kinds(middle) == [False]
    assert beside(8.0) == 9.0 and outer(8.0) == 6.0
    assert half(8.0) == 4.0 and least(16.0) == 4.0


def test_errors_of_inner_functions_reach_python():
    for _ in range(2):
        with pytest.raises(ValueError, match="below nothing"):
            outer(-8.0)
    with pytest.raises(ValueError, match="below nothing"):
        middle(-8.0)


def test_inner_functions_are_kept_on_disk_for_other_outer_ones(tmp_path):
    outer(8.0)
    kept = {file.name.split("-")[0].rpartition(".")[2] for file in (tmp_path / "cache").iterdir()}
    assert kept == {"outer", "middle", "half", "least"}
    for function in (middle, half, least):
        function._make_finalizer()()
        function._reset_overloads()
    assert beside(8.0) == 9.0
    assert sum(middle.stats.cache_hits.values()) == 1 and kinds(middle) == [True]
    assert sum(half.stats.cache_hits.values()) == 0, "it stands inside the other, and nobody asked for it"
    assert middle(8.0) == 3.0 and kinds(middle) == [False]


def test_another_type_of_argument_is_another_version():
    assert outer(8.0) == 6.0
    assert middle(np.float32(8.0)) == 3.0
    assert sorted(kinds(middle)) == [False, True]


def test_compiling_leaves_the_collector_of_garbage_as_it_was():
    before = gc.get_threshold()
    outer(8.0)
    assert gc.get_threshold() == before


@compiled
def times(x, count, negative):
    return -x * count if negative else x * count


@compiled
def item(pair, index):
    return pair[index]


@compiled
def with_constants(x):
    return times(x, 2, True) + times(x, 3, negative=False) + times(x, int(x), x > 5.0) + item((x, "two"), 0)


def test_constants_in_calls_need_no_version_of_their_own_unless_they_decide_types():
    assert with_constants(4.0) == -8.0 + 12.0 + 16.0 + 4.0
    assert [str(types) for types in times.overloads] == ["(float64, int64, bool)"]
    assert len(item.overloads) == 1 and "Literal[int](0)" in str(*item.overloads)
