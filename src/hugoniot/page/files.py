"""The page: its own files, named one by one, so that no other file can be asked for."""

from functools import cache
from pathlib import Path

STATIC = Path(__file__).parent / "static"
STYLES = ("style.css",)
SCRIPTS = ("base.js", "colours.js", "axis.js", "chart.js", "chart_drawing.js", "chart_pointer.js", "save.js", "material_list.js", "surface.js",
           "material_planes.js", "material_about.js", "material_commands.js", "materials.js", "match_curves.js", "match.js",
           "raster.js", "run_xt.js", "run_plane.js", "run_lines.js", "measured.js", "runs.js",
           "deck_words.js", "decks.js", "sweeps.js", "fits.js", "main.js")
KINDS = {"css": "text/css; charset=utf-8", "js": "text/javascript; charset=utf-8", "html": "text/html; charset=utf-8",
         "svg": "image/svg+xml"}


@cache
def files() -> dict[str, bytes]:
    """Name -> contents of every file of the page but index.html."""
    return {name: (STATIC / name).read_bytes() for name in (*STYLES, *SCRIPTS, "icon.svg")}


def index(exported: bool = False) -> bytes:
    """index.html; of an export with the policy in the page and the script that says where the data lie."""
    text = (STATIC / "index.html").read_text(encoding="utf-8")
    policy = "default-src 'none'; script-src 'self' file:; style-src 'self' file:; img-src 'self' file: data: blob:"
    head = f'<meta http-equiv="Content-Security-Policy" content="{policy}">' if exported else ""
    scripts = (("data/data.js",) if exported else ()) + SCRIPTS
    return text.replace("<!-- policy -->", head).replace(
        "<!-- scripts -->", "\n".join(f'<script src="{name}" defer></script>' for name in scripts)).encode()
