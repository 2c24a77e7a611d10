"""The wheel holds what a run needs: built, installed into an environment without the sources, and used there."""

import os
import subprocess
import sys
import sysconfig
import venv
import zipfile
from pathlib import Path

import pytest
from pace import PATIENCE

ROOT = Path(__file__).parents[2]


def call(*command, **options):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=PATIENCE, **options)
    assert done.returncode == 0, f"{command}: {done.stdout[-1500:]} {done.stderr[-1500:]}"
    return done.stdout


@pytest.mark.slow
def test_a_wheel_runs_where_there_are_no_sources(tmp_path):
    """The libraries it depends on are lent by this environment; hugoniot itself can only come from the wheel."""
    call(sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", tmp_path, ROOT)
    wheel = next(tmp_path.glob("hugoniot-*.whl"))
    names = set(zipfile.ZipFile(wheel).namelist())
    assert {"hugoniot/py.typed", "hugoniot/problem/templates/flyer.toml"} <= names
    sources = {path.relative_to(ROOT / "src").as_posix() for path in (ROOT / "src").rglob("*.py")}
    assert sources <= names
    home = tmp_path / "empty"
    venv.create(home, with_pip=False)
    python = home / "bin" / "python"
    site = Path(call(python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))").strip())
    call(sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--target", site, wheel)
    # a path file is read behind the environment's own packages, and its own path files are not followed
    (site / "lent.pth").write_text(sysconfig.get_path("purelib") + "\n")
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")} | {"HUGONIOT_CACHE": str(tmp_path / "cache")}
    (tmp_path / "cache").mkdir(mode=0o700)

    def hugoniot(*arguments):
        return call(python, "-m", "hugoniot.cli.main", *arguments, cwd=tmp_path, env=environment)

    where = call(python, "-c", "import hugoniot; print(hugoniot.__file__)", cwd=tmp_path, env=environment)
    assert Path(where.strip()).is_relative_to(site)
    hugoniot("init", "flyer")
    assert "voids opened 2" in hugoniot("run", "flyer.toml", "--set", "region.flyer.zones=200")
    assert (tmp_path / "flyer.run" / "report.html").is_file()
    assert "8930" in hugoniot("material", "show", "copper")
