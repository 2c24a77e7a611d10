"""The command line: immediate help, one clear message, the right exit code, never a traceback."""

import errno
import json
import os
import pathlib
import subprocess
import sys
import tempfile
from types import SimpleNamespace

import pytest
from pace import PATIENCE, in_starts

from hugoniot.cli import main as front
from hugoniot.cli.listing import KINDS
from hugoniot.cli.progress import Lines, Silent, duration, words
from hugoniot.cli.show import overrides_of
from hugoniot.errors import DeckError, FileTrouble, UnphysicalState

PRESENT = list(front.COMMANDS)


def call(capsys, *arguments):
    """(exit code, standard output, standard error) of one command."""
    with pytest.raises(SystemExit) as ended:
        front.main(list(arguments))
    out, err = capsys.readouterr()
    code = ended.value.code
    return 0 if code is None else code, out, err


def test_help_answers_at_once():
    """It costs little more than the import of the library of command lines; 0.3 s are asked for in benchmarks/answers.py."""
    ended = subprocess.run([sys.executable, "-m", "hugoniot.cli.main", "--help"], capture_output=True, text=True, timeout=PATIENCE)
    assert ended.returncode == 0 and "compare" in ended.stdout
    assert in_starts([["-m", "hugoniot.cli.main", "--help"]], ["-c", "import typer"], check=True)[0] < 2.0


def test_help_imports_no_slow_library():
    code = ("import sys\nfrom hugoniot.cli.main import main\ntry:\n    main(['--help'])\nexcept SystemExit:\n    pass\n"
            "print(sorted({'numpy', 'numba', 'pydantic', 'pint', 'h5py', 'xarray', 'matplotlib', 'scipy'} & set(sys.modules)))")
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=PATIENCE)
    assert ended.stdout.splitlines()[-1] == "[]"


def test_a_run_with_its_report_imports_no_library_it_can_do_without(tmp_path):
    """What a warm run of the flyer waits for is mostly libraries; a second process reads those that draw."""
    deck = pathlib.Path(__file__).parents[3] / "examples" / "sod.toml"
    code = (f"import os, sys\nos.sched_getaffinity = lambda of: {{0, 1}}\nfrom hugoniot.cli.main import main\n"
            f"try:\n    main(['run', {str(deck)!r}, '--out', {str(tmp_path / 'run')!r}])\nexcept SystemExit:\n    pass\n"
            "print(sorted({'matplotlib', 'pint', 'xarray', 'jsonschema', 'pandas', 'scipy.linalg'} & set(sys.modules)))")
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=PATIENCE)
    assert (tmp_path / "run" / "report.html").is_file()
    assert ended.stdout.splitlines()[-1] == "[]"


@pytest.mark.parametrize("arguments", [("check", "deck.toml"), ("material", "check", "deck.toml"), ("material", "list", "-m", "deck.toml")])
def test_a_file_that_may_not_be_read_ends_with_the_code_of_files(arguments, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "deck.toml").write_text("")

    real = os.open

    def refuse(path, *words, **more):
        if str(path).endswith("deck.toml"):
            raise PermissionError(errno.EACCES, "Permission denied")
        return real(path, *words, **more)

    monkeypatch.setattr("os.access", lambda *_, **__: False)
    monkeypatch.setattr("os.open", refuse)
    code, _, err = call(capsys, *arguments)
    assert code == 4 and "deck.toml: Permission denied" in err


@pytest.mark.parametrize("arguments, words", [
    (("--integrator", "wilkin"), "--integrator: unknown integrator 'wilkin'; did you mean 'wilkins'?"), (("-n", "0"), "--zones: 0 zones are too few")])
def test_verify_names_what_it_cannot_run(arguments, words, capsys):
    code, out, err = call(capsys, "verify", "sod", *arguments)
    assert code == 2 and not out and words in err


def test_a_command_that_is_proposed_can_be_pasted_where_a_name_has_spaces(capsys, tmp_path):
    code, out, _ = call(capsys, "init", "flyer", "--out", str(tmp_path / "my deck.toml"))
    assert code == 0 and out.splitlines()[-1] == f"next: hugoniot run '{tmp_path}/my deck.toml'"
    (tmp_path / "my run" / "checkpoint").mkdir(parents=True)
    assert f"hugoniot resume '{tmp_path}/my run'`" in call(capsys, "info", str(tmp_path / "my run"))[2]


@pytest.mark.parametrize("name", PRESENT)
def test_every_command_explains_itself(name, capsys):
    code, out, _ = call(capsys, name, "--help")
    assert code == 0
    assert "xample" in out or "COMMAND" in out, f"hugoniot {name} --help shows no example"


def test_version(capsys):
    from hugoniot import __version__
    assert call(capsys, "--version")[:2] == (0, f"hugoniot {__version__}\n")


def test_a_mistyped_command_is_corrected(capsys):
    code, _, err = call(capsys, "chek")
    assert code == 2 and "check" in err


@pytest.mark.parametrize("error, code", [
    (DeckError.single("d.toml", 3, "x", "bad"), 2), (UnphysicalState("tangled"), 3), (FileTrouble("no such file"), 4), (PermissionError(13, "denied"), 4),
    (MemoryError(), 4), (KeyboardInterrupt(), 130), (ZeroDivisionError("oh"), 1),
])
def test_every_error_ends_with_its_code_and_no_traceback(error, code, capsys, monkeypatch):
    def command():
        raise error
    monkeypatch.setattr(front, "_mount", lambda app, name, module, line: app.command(name)(front.guarded(command)))
    found, out, err = call(capsys, "check")
    assert (found, out) == (code, "")
    assert "Traceback" not in err and err.strip()


def test_a_defect_keeps_its_traceback_in_a_file(capsys, monkeypatch, tmp_path):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))

    def command():
        raise ZeroDivisionError("oh")
    monkeypatch.setattr(front, "_mount", lambda app, name, module, line: app.command(name)(front.guarded(command)))
    code, _, err = call(capsys, "check")
    kept = list(tmp_path.glob("hugoniot-error-*.log"))
    assert code == 1 and len(kept) == 1 and str(kept[0]) in err
    assert "ZeroDivisionError: oh" in kept[0].read_text()


def test_init_writes_a_deck_that_check_accepts(capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    assert call(capsys, "init", "flyer")[0] == 0
    code, out, _ = call(capsys, "check", "flyer.toml")
    assert code == 0 and "200 zones" in out and "the deck is valid" in out
    code, _, err = call(capsys, "init", "flyer")
    assert code == 4 and "--overwrite" in err
    code, _, err = call(capsys, "init", "flier")
    assert code == 2 and "did you mean 'flyer'?" in err


@pytest.mark.parametrize(("name", "laws"), [
    ("initiation", "jwl_unreacted burning to jwl, thermal_isolation, ignition_growth"), ("detonation", "jwl, burned_products, programmed")])
def test_check_names_every_law_a_burning_region_runs_with(capsys, monkeypatch, tmp_path, name, laws):
    monkeypatch.chdir(tmp_path)
    call(capsys, "init", name)
    code, out, _ = call(capsys, "check", f"{name}.toml")
    assert code == 0 and laws in out


def test_check_tells_programs_what_is_wrong(capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    call(capsys, "init", "flyer")
    code, out, _ = call(capsys, "check", "flyer.toml", "--json", "--set", "region.flyer.velocity=900 mm")
    told = json.loads(out)
    assert code == 2 and told["ok"] is False
    # an option's value stands in no line of the deck
    assert told["problems"][0]["key"] == "region.flyer.velocity" and told["problems"][0]["line"] is None
    deck = tmp_path / "flyer.toml"
    deck.write_text(deck.read_text().replace("700 m/s", "700 mm"))
    code, out, _ = call(capsys, "check", "flyer.toml", "--json")
    told = json.loads(out)
    assert code == 2 and told["problems"][0]["key"] == "region.flyer.velocity" and told["problems"][0]["line"] == 14
    code, out, _ = call(capsys, "check", "flyer.toml", "--resolved", "--set", "region.flyer.velocity=900 m/s")
    assert code == 0 and "velocity = 900.0" in out


@pytest.mark.parametrize("kind", ["", "eos", "strength", "fracture", "viscosity", "materials", "fields", "problems", "solvers"])
def test_list_explains_each_in_a_line(kind, capsys):
    code, out, _ = call(capsys, "list", kind, "--json")
    rows = json.loads(out)
    assert code == 0 and rows
    code, out, _ = call(capsys, "list", kind)
    assert code == 0 and all(next(iter(row.values())) in out for row in rows)


def test_list_shows_the_parameters_of_a_law(capsys):
    code, out, _ = call(capsys, "list", "eos", "mie_gruneisen")
    assert code == 0 and "c0" in out and "m/s" in out and "Starkenberg" in out
    code, _, err = call(capsys, "list", "eos", "mie_grunisen")
    assert code == 2 and "did you mean 'mie_gruneisen'?" in err


def test_schema_is_json(capsys):
    code, out, _ = call(capsys, "list", "schema")
    assert code == 0 and "region" in json.loads(out)["properties"]


@pytest.mark.parametrize("settings, expected", [
    (["a.b=3"], {"a.b": 3}), (["v=800 m/s"], {"v": "800 m/s"}), (['v="800 m/s"'], {"v": "800 m/s"}), (["v=[1.0, 2.0]"], {"v": [1.0, 2.0]}),
    (["x=true"], {"x": True}), (["x=a=b"], {"x": "a=b"}), (None, {}),
])
def test_settings(settings, expected):
    assert overrides_of(settings) == expected


def test_a_setting_without_a_value_is_refused():
    with pytest.raises(DeckError, match="KEY=VALUE"):
        overrides_of(["velocity"])


REPORT = SimpleNamespace(time=1e-6, stop_time=4e-6, cycle=500, step=2e-9, limiting_zone=7, limiting_region="flyer", energy_error=3e-16)


def later(report, **changes):
    return SimpleNamespace(**{**vars(report), **changes})


def test_the_time_left_is_estimated_from_the_first_report_on(monkeypatch):
    wall = iter([100.0, 103.0])  # whatever came before the first report was compilation
    monkeypatch.setattr("hugoniot.cli.progress.time.monotonic", lambda: next(wall))
    display = Silent()
    assert display.left(REPORT) == float("inf")
    assert display.left(later(REPORT, time=2e-6)) == pytest.approx(6.0)  # 1 us took 3 s, 2 us are left


def test_progress_without_a_terminal_is_a_line_now_and_then(capsys):
    lines = Lines(interval=0.0)
    lines.update(REPORT)
    told = capsys.readouterr().err
    for part in ("25%", "1 us", "cycle 500", "zone 7 of flyer", "3.0e-16", "time left unknown"):
        assert part in told
    slow = Lines(interval=1000.0)
    slow.update(REPORT)
    assert capsys.readouterr().err == ""


def test_the_bar_shows_time_step_zone_error_and_what_is_left():
    from hugoniot.cli.progress import Bar
    bar = Bar()
    bar.update(REPORT)
    task = bar.display.tasks[0]
    assert task.percentage == 25.0 and words(REPORT) in task.description and "time left unknown" in task.description


@pytest.mark.parametrize("seconds, text", [(0.4, "0 s"), (59.0, "59 s"), (61.0, "1:01"), (3723.0, "1:02:03"), (float("inf"), "unknown")])
def test_durations(seconds, text):
    assert duration(seconds) == text


def test_the_process_ends_with_the_commands_code_and_all_it_said():
    called = [sys.executable, "-m", "hugoniot.cli.main"]
    ended = subprocess.run([*called, "list", "eos"], capture_output=True, text=True, timeout=PATIENCE)
    assert ended.returncode == 0 and "mie_gruneisen" in ended.stdout
    assert subprocess.run([*called, "run", "no such deck.toml"], capture_output=True, timeout=PATIENCE).returncode == 4
    with open("/dev/full", "w") if pathlib.Path("/dev/full").exists() else pytest.skip("no device that is always full") as full:
        assert subprocess.run([*called, "list", "eos"], stdout=full, stderr=subprocess.DEVNULL, timeout=PATIENCE).returncode == 4


def test_an_application_may_be_built_any_number_of_times():
    for _ in range(3):
        front.build_app("eos")
    module = front.module_of("eos")
    assert not any(hasattr(info.callback.__wrapped__, "__wrapped__") for info in module.app.registered_commands)


@pytest.mark.parametrize("kind", ["transport", "conduction"])
def test_list_names_the_table_of_transport_laws_in_the_default_solver(kind):
    """[solver.transport] is a table of shock_structure; lagrange1d refuses it."""
    assert "[transport.MATERIAL]" in KINDS[kind] and "shock_structure: [solver.transport]" in KINDS[kind]
