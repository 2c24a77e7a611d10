"""The folder of compiled code and what may stand in it."""

import subprocess
import sys

SCRIPT = """
import sys
from numba.core.caching import IndexDataCacheFile
import hugoniot.core.cache

folder, mode = sys.argv[1:]
file = IndexDataCacheFile(folder, "march", "stamp")
if mode == "write":
    sys.path.insert(0, folder)
    import law_of_a_script
    file.save(("signature", law_of_a_script.Mine), "code of another")
else:
    assert file.load("signature of its own") is None
    file.save("signature of its own", "its code")
    assert file.load("signature of its own") == "its code"
"""


def test_an_index_that_names_a_law_of_a_script_keeps_no_other_run_from_compiling(tmp_path):
    """Runs after such a one ended with ModuleNotFoundError, until the folder was deleted."""
    (tmp_path / "law_of_a_script.py").write_text("class Mine:\n    pass\n")
    for mode in ("write", "read"):
        done = subprocess.run([sys.executable, "-c", SCRIPT, str(tmp_path), mode], capture_output=True, text=True, timeout=60)
        assert done.returncode == 0, done.stderr
