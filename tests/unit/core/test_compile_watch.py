"""Compiling is announced, counted and timed apart from what runs."""

import time
from typing import NamedTuple

import numba as nb
import pytest

from hugoniot.cli.progress import Lines, compiling_words
from hugoniot.core import code_files, compile_watch
from hugoniot.core.compile_watch import Compiling, compile_seconds, expect, when_compiling
from hugoniot.core.target import GUARD


class Slope(NamedTuple):
    a: float


def kernels():
    """An inner kernel that an outer one calls, and a C function, all yet to be compiled."""
    @nb.njit(**GUARD)
    def inner(x, par):
        return par.a * x

    @nb.njit(**GUARD)
    def outer(x, par):
        return inner(x, par) + 1.0

    def called():
        return nb.cfunc("float64(float64)", cache=True)(lambda x: 2.0 * x)

    return outer, inner, called


@pytest.fixture
def nothing_kept(monkeypatch):
    monkeypatch.setattr(code_files, "cache_folder", lambda: None)


def test_a_kernel_is_announced_with_its_law_and_counted_once_with_what_it_calls(nothing_kept):
    outer, inner, called = kernels()
    news, begun = [], time.perf_counter()
    with when_compiling(news.append):
        expect(2)
        assert outer(3.0, Slope(2.0)) == 7.0
        between = compile_seconds(begun)
        called()
        assert outer(3.0, Slope(2.0)) == 7.0 and inner(3.0, Slope(2.0)) == 6.0
    assert [one.kernel for one in news] == ["outer for Slope", "<lambda>"]
    assert [one.left for one in news] == [1, 0] and news[1].number == news[0].number + 1
    assert 0.0 < between < compile_seconds(begun) < time.perf_counter() - begun
    assert compile_seconds(time.perf_counter()) == 0.0
    kernels()[0](3.0, Slope(2.0))
    assert len(news) == 2


def test_a_kernel_that_does_not_compile_leaves_the_watch_sound(nothing_kept):
    @nb.njit(**GUARD)
    def wrong(x):
        return x.nothing

    outer, _, _ = kernels()
    news = []
    with when_compiling(news.append):
        with pytest.raises(nb.TypingError):
            wrong(1.0)
        outer(3.0, Slope(2.0))
    assert [one.kernel for one in news] == ["wrong", "outer for Slope"]
    assert getattr(compile_watch._here, "began", None) is None


def test_what_is_kept_is_known_before_it_is_asked_for(tmp_path, monkeypatch):
    monkeypatch.setattr(code_files, "cache_folder", lambda: tmp_path)
    monkeypatch.setattr(code_files.sources, "changed_since_start", lambda paths: False)
    outer, _, _ = kernels()
    arguments = (nb.float64, nb.typeof(Slope(2.0)))
    assert not code_files.kept_at(outer.py_func, arguments).exists()
    outer(3.0, Slope(2.0))
    assert code_files.kept_at(outer.py_func, arguments).exists()
    assert not code_files.kept_at(outer.py_func, (nb.float32, arguments[1])).exists()


@pytest.mark.parametrize("left, said", [(None, "kernel 4,"), (0, "kernel 4 of 4,"), (3, "kernel 4 of 7,")])
def test_the_line_says_which_and_of_how_many(left, said, capsys):
    line = compiling_words(Compiling("f for A", 4, left))
    assert line == f"compiling {said} once for this machine"
    display = Lines()
    for _ in range(3):       # a line every few seconds, not one for each kernel
        display.compiling(Compiling("f for A", 4, left))
    assert capsys.readouterr().err == line + "\n"
