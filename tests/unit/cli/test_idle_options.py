"""An option that would have no effect beside the others is refused, with its name."""

import pytest
from typer.main import get_command

from hugoniot.cli.main import COMMANDS, build_app, main

IDLE = [
    ("--points", "eos hugoniot copper --points 7 --at", "pressure = 10 GPa"),
    ("--points", "eos hugoniot copper --points 101 --at", "pressure = 10 GPa"),      # the default, typed
    ("--up-to", "eos hugoniot copper --at", "pressure = 10 GPa", "--up-to", "1 km/s"),
    ("--axes", "eos hugoniot copper --axes us-up"),
    ("--overdrive", "eos znd lx_17 --overdrive 1.2 --velocity", "9 km/s"),
    ("--points", "eos mixture lx_17 --points 5 --shocked", "pressure = 20 GPa"),
    ("--burn-to", "eos mixture lx_17 --burn-to 1 --shocked", "pressure = 20 GPa"),
    ("--burn-fraction", "eos mixture lx_17 --series --burn-fraction 0.5 --shocked", "pressure = 20 GPa"),
    ("--burn-fraction", "eos mixture lx_17 --burn-fraction 0.5,1 --shocked", "pressure = 20 GPa", "--adiabat", "1 g/cm^3"),
    ("--series", "eos mixture lx_17 --series --closure thermal_isolation --closure thermal_equilibrium --shocked", "pressure = 20 GPa"),
    ("gamma1", "eos convert linear rho0=2785 c0=5328 s=1.338 gamma1=1"),
    ("expansion", "eos convert linear rho0=2785 c0=5328 s=1.338 gamma0=2 expansion=7e-5"),
    ("--plot", "exact --plot a.png"),
    ("--points", "exact sod --points 11"),
    ("--to", "exact sod --time 0.1 --at 0.5 --to 2"),
    ("--from", "exact plate_push --from 0"),
    ("--port", "explore --export a --port 8000"),
    ("--no-browser", "explore --export a --no-browser"),
    ("--work", "explore --no-runs --work a"),
    ("--events", "info a.run --verify --events"),
    ("--json", "info a.run --deck --json"),
    ("flyer", "init flyer --schema"),
    ("--out", "init --out a.toml"),
    ("copper", "list materials copper"),
    ("--to", "fit-rate pbx_9502 --to R001", "--line", "1.1, -0.6"),
    ("--points", "pop-plot pbx_9502 --points 3 --pressures", "8, 11 GPa"),
    ("--points", "structure profile water_858 --points 9"),
    ("--mean-free-path", "structure sweep water_858 --points 2 --mean-free-path vhs"),
    ("--all", "material list --counts --all"),
    ("metal", "material list metal --summary"),
    ("--seed", "sweep a.toml --seed 3 --vary", "stop_time = 1, 2 us"),
    ("--match", "sweep a.toml --match copper,aluminum --vary", "velocity = 1, 2 km/s"),
]


@pytest.mark.parametrize("option, line, rest", [(option, line, rest) for option, line, *rest in IDLE],
                         ids=[f"{line.split(' --')[0]} {option}" for option, line, *_ in IDLE])
def test_an_option_without_effect_is_refused(option, line, rest, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.toml").write_text('stop_time = "1 us"\n[[region]]\nname = "a"\nmaterial = "copper"\nfrom = 0.0\nto = 1e-3\nzones = 4\n')
    with pytest.raises(SystemExit) as end:
        main([*line.split(), *rest])
    said = capsys.readouterr()
    assert end.value.code == 2 and option in said.err and not said.out
    assert [file.name for file in tmp_path.iterdir()] == ["a.toml"]


@pytest.mark.parametrize("line", ["eos hugoniot copper --points 3", "exact sod --time 0.1 --points 5", "structure profile water_858 --points 3 --json",
                                  "list eos ideal_gas", "eos convert linear rho0=2785 c0=5328 s=1.338 gamma0=2 gamma1=1"])
def test_an_option_with_effect_is_not(line, capsys):
    with pytest.raises(SystemExit) as end:
        main(line.split())
    assert end.value.code == 0, capsys.readouterr().err


SAME = {"--jobs": "--workers", "--mixture": "--closure", "--up": "--up-to"}     # one thing, one name


def test_a_thing_has_the_same_option_in_every_command():
    """A file or folder to write is --out with -o everywhere, and no option goes by another's synonym."""
    seen = {}
    for name in COMMANDS:
        command = get_command(build_app(name)).commands[name]
        for each in getattr(command, "commands", {name: command}).values():
            seen |= {option: parameter for parameter in each.params for option in parameter.opts if option.startswith("-")}
            assert all(("--out" in p.opts) == ("-o" in p.opts) for p in each.params)
    assert not SAME.keys() & seen.keys() and set(SAME.values()) <= seen.keys()
