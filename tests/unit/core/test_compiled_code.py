"""The folder of compiled code: what is found in it again, what never is, and whom it trusts."""

import os
import pathlib
import runpy
import stat
import subprocess
import sys
import time
import traceback
import warnings

import numba as nb
import pytest
from pace import PATIENCE

import compile_once
from hugoniot.core import cache, sources
from hugoniot.core import machine as machine_module
from hugoniot.core.code_files import _is_sound
from hugoniot.core.machine import machine, machine_name

FAMILY = """
from hugoniot.core.registry import Registry
FAMILY = Registry("toy", contract=("value",))
def value(x, par):
    return FAMILY.of(par).functions["value"](x, par)
"""
LAW = """
from typing import NamedTuple
from family import FAMILY
from helper import helped
class Toy(NamedTuple):
    a: float
def value(x, par):
    return par.a * helped(x)
FAMILY.add("NAME", Toy, functions=[value], example=Toy(1.0), units={"a": "1"}, meaning={"a": "factor"}, box={}, references=("none",))
"""
HELPER = "def helped(x):\n    return 10.0 * x\n"
KERNELS = """
import numba as nb
from family import FAMILY, value
from hugoniot.core.binder import bind_family
from hugoniot.core.target import GUARD
bind_family(FAMILY, {"value": value})
@nb.njit(**GUARD)
def kernel(x, par):
    return value(x, par)
def add(x):
    return x + 1.0
def scale(x):
    return x * 100.0
def made(function):
    function = nb.njit(function)
    @nb.njit(**GUARD)
    def passing(x):
        return function(x)
    @nb.cfunc("float64(float64)", cache=True)
    def called(x):
        return function(x)
    assert called.ctypes(3.0) == function(3.0)
    return passing
"""
MAIN = """
import sys
import kernels
for word in sys.argv[1:]:
    if word in ("add", "scale"):
        used, args = kernels.made(getattr(kernels, word)), (7.0,)
    else:
        used, args = kernels.kernel, (3.0, __import__(word).Toy(2.0))
    print(used(*args), sum(used.stats.cache_hits.values()), sum(used.stats.cache_misses.values()))
    used.stats.cache_hits.clear()
    used.stats.cache_misses.clear()
"""


@pytest.fixture(scope="module")
def compiler():
    """The compiler, with all that it reads when it compiles for the first time: forks have it then."""
    nb.njit(lambda x: x + 1.0)(1.0)


@pytest.fixture
def users(tmp_path, compiler):
    """A folder of a user's scripts, and a function that runs them: (value, hits, misses) of every kernel asked for.

    They run in a process of its own where `process` says so, or variables of its environment; else in a fork, which has begun to know
    files, folders and kernels only then but need not load the compiler.
    """
    for name, text in (("family", FAMILY), ("law", LAW), ("helper", HELPER), ("kernels", KERNELS), ("main", MAIN)):
        (tmp_path / f"{name}.py").write_text(text)

    def run(*words, folder=None, warned=None, process=False, **environment):
        folder = folder or tmp_path / "cache"
        if process or environment or not hasattr(os, "fork"):
            done = start(tmp_path, words, folder, environment)
            (out, err), status = done.communicate(timeout=PATIENCE), done.returncode
        else:
            out, err, status = forked(tmp_path, words, folder)
        assert status == 0, err
        assert warned in err if warned else "Warning" not in err
        return [tuple(float(x) for x in line.split()) for line in out.splitlines()]

    run.folder = tmp_path
    return run


def forked(place, words, folder):
    """(output, errors, exit status) of main.py in a fork that knows of the package's kernels what a new process knows."""
    paths = place / "output", place / "errors"
    child = os.fork()
    if child == 0:
        status = 1
        try:
            with open(paths[0], "w") as sys.stdout, open(paths[1], "w") as sys.stderr:
                try:
                    compile_once.here()
                    os.environ["HUGONIOT_CACHE"] = str(folder)
                    os.chdir(place)
                    sys.path.insert(0, str(place))
                    sys.argv = ["main.py", *words]
                    sys.dont_write_bytecode = True
                    warnings.simplefilter("default")
                    warnings.showwarning = lambda text, kind, *where: sys.stderr.write(f"{kind.__name__}: {text}\n")
                    for module in (cache, machine_module, sources):
                        for function in vars(module).values():
                            getattr(function, "cache_clear", int)()
                    sources._unchanged.clear()
                    sources._BEGUN = sources._begun()
                    runpy.run_path("main.py", run_name="__main__")
                    status = 0
                except BaseException:
                    traceback.print_exc()
        finally:
            os._exit(status)
    ended = os.waitpid(child, 0)[1]
    return paths[0].read_text(), paths[1].read_text(), ended


def start(place, words, folder, environment=()):
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "HUGONIOT_CACHE": str(folder),
                   "PYTHONPATH": str(pathlib.Path(sources.ROOT).parent), **dict(environment)}
    return subprocess.Popen([sys.executable, "main.py", *words], cwd=place, env=environment, text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE)


def kept(folder):
    return sorted(pathlib.Path(folder).rglob("*.code"))


def test_compiled_code_is_found_again_and_an_edit_never_meets_stale_code(users):
    """The kernel's file does not import the law: its class in the arguments does, and the law imports the helper."""
    assert users("law", process=True) == [(60.0, 0, 1)]
    assert users("law", process=True) == [(60.0, 1, 0)]
    assert users("law") == [(60.0, 1, 0)]
    assert users("law", NUMBA_CPU_NAME="generic") == [(60.0, 0, 1)]
    assert len({path.parent for path in kept(users.folder)}) == 2
    (users.folder / "law.py").write_text(LAW.replace("return par.a", "return 1.0 + par.a"))
    assert users("law") == [(61.0, 0, 1)]
    (users.folder / "helper.py").write_text(HELPER.replace("10.0", "20.0"))
    assert users("law") == [(121.0, 0, 1)]


def test_laws_of_one_name_and_kernels_of_one_factory_are_kept_apart(users):
    (users.folder / "law.py").write_text(LAW.replace("NAME", "one"))
    (users.folder / "other.py").write_text(LAW.replace("NAME", "two").replace("par.a *", "par.a -"))
    assert users("law", "add") == [(60.0, 0, 1), (8.0, 0, 1)]
    assert users("other", "scale") == [(-28.0, 0, 1), (700.0, 0, 1)]
    # of two classes of one name the second is numbered, and compiled under its number
    for _ in range(2):
        together = users("law", "other", "add", "scale")
        assert [value for value, _, _ in together] == [60.0, -28.0, 8.0, 700.0]
    assert all((hits, misses) == (1, 0) for _, hits, misses in together)


def test_flipped_bytes_and_planted_links_are_noticed_and_compiled_anew(users):
    assert users("law", "add") == [(60.0, 0, 1), (8.0, 0, 1)]
    one, other = [path for path in kept(users.folder) if "called" not in path.name]
    whole = one.read_bytes()
    assert _is_sound(one)
    for at in [*range(0, len(whole), len(whole) // 200), len(whole) - 1]:
        data = bytearray(whole)
        data[at] ^= 0x10
        one.write_bytes(data)
        assert not _is_sound(one)
    for length in (0, 20, len(whole) - 1):
        one.write_bytes(whole[:length])
        assert not _is_sound(one)
    other.rename(users.folder / "elsewhere")
    other.symlink_to(users.folder / "elsewhere")
    assert users("law", "add") == [(60.0, 0, 1), (8.0, 0, 1)]
    assert one.read_bytes()[-32:] != whole[:-1][-32:] and not other.is_symlink() and _is_sound(one) and _is_sound(other)


@pytest.mark.parametrize("count", [2, pytest.param(8, marks=pytest.mark.slow)])
def test_processes_that_fill_a_fresh_folder_at_once_do_not_disturb_each_other(users, count):
    team = [start(users.folder, ("law", "add", "scale"), users.folder / "cache") for _ in range(count)]
    for one in team:
        out, err = one.communicate(timeout=PATIENCE)
        assert one.returncode == 0 and "Warning" not in err, err
        assert [line.split()[0] for line in out.splitlines()] == ["60.0", "8.0", "700.0"]
    assert all(misses == 0 for _, _, misses in users("law", "add", "scale", process=True))
    assert not list((users.folder / "cache").rglob("*.tmp.*"))


@pytest.mark.slow
def test_runs_that_fill_a_fresh_folder_at_once_give_the_same_bits(users):
    (users.folder / "main.py").write_text("import sys, hugoniot\nrun = hugoniot.run(sys.argv[1], out=sys.argv[2], report=False)\n"
                                          "print(*(float(v).hex() for v in run.gauges['velocity'].values[-1]))\n")
    deck = pathlib.Path(sources.ROOT).parents[1] / "examples" / "flyer.toml"
    team = [start(users.folder, (str(deck), f"run{i}"), users.folder / "cache") for i in range(8)]
    said = {one.communicate(timeout=PATIENCE)[0] for one in team}
    assert all(one.returncode == 0 for one in team)
    assert len(said) == 1 and said.pop().strip()


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="rights of files are of POSIX")
def test_a_folder_that_others_may_write_to_is_not_read(users):
    folder = users.folder / "cache"
    assert users("law") == [(60.0, 0, 1)]
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700
    for place in (folder, folder / machine_name()):
        place.chmod(0o777)
        assert users("law", warned="other users may write to") == [(60.0, 0, 1)]
        place.chmod(0o700)


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="rights of files are of POSIX")
def test_a_folder_or_link_of_another_user_is_not_trusted(tmp_path, monkeypatch):
    (tmp_path / "link").symlink_to(tmp_path)
    assert cache.open_to_others(tmp_path) is None and cache.open_to_others(tmp_path / "link") is None
    monkeypatch.setattr(os, "getuid", lambda: tmp_path.stat().st_uid + 1)
    assert "another user" in cache.open_to_others(tmp_path)
    monkeypatch.undo()
    if os.getuid() == 0:      # only then can one make a link that belongs to somebody else
        os.chown(tmp_path / "link", 12345, 12345, follow_symlinks=False)
        assert "another user" in cache.open_to_others(tmp_path / "link")


def test_a_folder_that_cannot_be_made_costs_only_a_warning(users):
    (users.folder / "file").write_text("")
    assert users("law", folder=users.folder / "file", warned="compiled kernels cannot be kept") == [(60.0, 0, 1)]


def test_the_machine_is_described():
    assert set(machine()) == {"cpu", "features", "system", "compiler", "python"} and all(machine().values())


def test_code_of_what_was_written_after_the_start_is_not_kept(tmp_path):
    """The process may have imported what stood there before."""
    new = tmp_path / "new.py"
    new.write_text("")
    assert sources.changed_since_start([str(new)])
    for moved in (-1e6, 1e4):
        os.utime(new, (time.time() + moved,) * 2)
        assert not sources.changed_since_start([str(new)])
        sources._unchanged.clear()


def test_what_nothing_has_used_for_long_is_cleared_away(tmp_path):
    now, folder, before = time.time(), tmp_path / "anycpu-0123456789ab", tmp_path / "0123456789abcdef" / "solver_1"
    ages = {folder / "new.code": 0.1, folder / "used.code": 50.0, folder / "old.code": 70.0, folder / "new.code.tmp.12": 2.0,
            before / "old.nbc": 70.0, folder / "foreign.txt": 900.0, tmp_path / "mine" / "old.code": 900.0}
    for path, days in ages.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(bytes(1000))
        os.utime(path, (now - days * cache.DAY,) * 2)
    cache.clear_away(tmp_path, now)
    assert {path for path in ages if path.exists()} == {folder / "new.code", folder / "used.code", folder / "foreign.txt",
                                                        tmp_path / "mine" / "old.code"}
    assert not before.parent.exists()
    cache.clear_away(tmp_path, now + 0.5 * cache.DAY, most_bytes=0)
    assert (folder / "used.code").exists()           # once a day
    cache.clear_away(tmp_path, now + 0.95 * cache.DAY + 0.1 * cache.DAY, most_bytes=0)
    assert not (folder / "used.code").exists()


def test_the_files_behind_a_kernel_are_those_it_imports():
    behind = {os.path.relpath(path, sources.ROOT) for path in sources.behind(["hugoniot.laws.array_kernels"])}
    assert {"laws/array_kernels.py", "laws/eos/contract.py", "core/mathematics.py", "core/binder.py"} <= behind
    assert "laws/mixture/binding.py" in behind        # says how mixture laws are compiled, whoever calls them
    assert not any(path.startswith(("cli", "output", "laws/eos/tait", "solvers/lagrange1d/step")) for path in behind)
    wrapper = {os.path.relpath(path, sources.ROOT) for path in sources.behind(["hugoniot.laws.eos.p_alpha"])}
    assert {"laws/eos/p_alpha.py", "laws/eos/mie_gruneisen.py", "laws/eos/reference_curves.py", "laws/eos/special.py"} <= wrapper
    assert "laws/eos/tait.py" not in wrapper


WATCHED = """
import os, sys
from numba.core import event
from hugoniot.core import code_files, sources

class Watch(event.Listener):
    open = []
    def on_start(self, event):
        function = event.data["dispatcher"].py_func
        if not self.open:
            self.behind = sources.behind({function.__module__, *(cls.__module__ for cls in code_files._classes(event.data["args"]))})
        self.open.append(function)
        path = os.path.realpath(function.__code__.co_filename)
        assert "site-packages" in path or path in self.behind, (self.open[0].__qualname__, function.__qualname__, path)
        print("seen", path)
    def on_end(self, event):
        self.open.pop()

with event.install_listener("numba:compile", Watch()):
    if sys.argv[1].endswith(".toml"):
        import hugoniot
        hugoniot.run(sys.argv[1], out="run", report=False, stop_time=float(sys.argv[2]))
    else:
        import numpy as np
        from hugoniot.laws import arrays
        from hugoniot.laws.eos.contract import EOS
        law = EOS.get(sys.argv[1])
        arrays.evaluate(law.example, np.linspace(*law.box["rho"], arrays.SMALL + 9), np.zeros(arrays.SMALL + 9), "pressure", "sound_speed")
"""


@pytest.mark.parametrize("what", ["p_alpha", pytest.param("flyer.toml 1e-8", marks=pytest.mark.slow),
                                  pytest.param("initiation.toml 1e-8", marks=pytest.mark.slow),
                                  pytest.param("noh.toml 1e-3", marks=pytest.mark.slow)])
def test_nothing_is_compiled_into_a_kernel_whose_file_is_not_behind_it(users, what):
    (users.folder / "main.py").write_text(WATCHED)
    words = what.split()
    if words[0].endswith(".toml"):
        words[0] = str(pathlib.Path(sources.ROOT).parents[1] / "examples" / words[0])
    done = start(users.folder, words, users.folder / "cache")
    out, err = done.communicate(timeout=PATIENCE)
    assert done.returncode == 0, err[-3000:]
    assert out.count("seen") > 5


@pytest.mark.parametrize("statement, names", [
    ("import a.b as c, d", {"a.b", "d"}), ("from a import (b,  # why\n  c as d,\n)", {"a", "a.b", "a.c"}),
    ("def f():\n    from a.b import c", {"a.b", "a.b.c"}), ("from a import b, \\\n    c", {"a", "a.b", "a.c"}),
    ("x = importlib.import_module('hugoniot.solvers.' + x)", {"hugoniot.solvers"}), ("from .a import b", {".a", ".a.b"})])
def test_imports_are_read_from_the_text(tmp_path, statement, names):
    path = tmp_path / "some.py"
    path.write_text(f'"""Text that must import nothing."""\n{statement}\n')
    found = sources._imports(str(path))
    assert {*found.names, *found.quoted} - {"nothing"} == names


def test_relative_imports_are_counted_from_their_package():
    assert sources._absolute(".a", "p.q") == "p.q.a" and sources._absolute("..a.b", "p.q") == "p.a.b" and sources._absolute("a", "p") == "a"
