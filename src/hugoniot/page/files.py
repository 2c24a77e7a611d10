"""The page: its own files, named one by one, so that no other file can be asked for."""

from functools import cache
from pathlib import Path

STATIC = Path(__file__).parent / "static"
STYLES = ("style.css",)
THEORY = "theory.js"      # not a file: the explorer writes it from the sources of laws and theory
_BASE = ("base.js", "colours.js", "axis.js", "chart.js", "chart_drawing.js", "chart_pointer.js", "save.js")
_RUNS = ("raster.js", "run_xt.js", "run_plane.js", "run_lines.js", "measured.js", "runs.js")
_MATERIALS = ("material_list.js", "surface.js", "material_planes.js", "material_about.js", "material_commands.js", "materials.js")
SCRIPTS = (*_BASE, THEORY, "impact.js", *_MATERIALS, "match.js", *_RUNS, "deck_words.js", "decks.js", "sweeps.js", "fits.js", "report.js",
           "main.js")
OF_A_RUN = (*_BASE, *_RUNS, "report.js", "main.js")
KINDS = {"css": "text/css; charset=utf-8", "js": "text/javascript; charset=utf-8", "html": "text/html; charset=utf-8",
         "svg": "image/svg+xml"}


@cache
def files() -> dict[str, bytes]:
    """Name -> contents of every file of the page but index.html and the transcribed theory."""
    return {name: (STATIC / name).read_bytes() for name in (*STYLES, *SCRIPTS, "icon.svg") if name != THEORY}


def index(exported: bool = False) -> bytes:
    """index.html; of an export with the policy in the page and the script that says where the data lie."""
    text = (STATIC / "index.html").read_text(encoding="utf-8")
    policy = "default-src 'none'; script-src 'self' file:; style-src 'self' file:; img-src 'self' file: data: blob:"
    head = f'<meta http-equiv="Content-Security-Policy" content="{policy}">' if exported else ""
    scripts = (("data/data.js",) if exported else ()) + SCRIPTS
    return text.replace("<!-- policy -->", head).replace(
        "<!-- scripts -->", "\n".join(f'<script src="{name}" defer></script>' for name in scripts)).encode()


@cache
def report_script() -> str:
    """The scripts of the views that a report has, as one; it holds nothing that ends a script."""
    text = "\n".join(files()[name].decode() for name in OF_A_RUN)
    if "</script" in text or "<!--" in text:
        raise ValueError("a script of the page contains text that would close its own script tag")
    return text


@cache
def frame() -> str:
    """What stands around the views, hidden until the scripts run: of index.html the parts in its body, without the picture it fetches."""
    text = (STATIC / "index.html").read_text(encoding="utf-8")
    body = text[text.index("<header>"):text.index("</body>")]
    start, end = body.index('<main id="main"'), body.index("</main>") + len("</main>")
    picture = body.index("<img "), body.index(">", body.index("<img ")) + 1
    head, foot = body[:picture[0]] + body[picture[1]:start], body[end:]
    return "".join([head.replace("<header>", "<header hidden>"), '<main id="main" tabindex="-1" hidden></main>',
                    foot.replace("<footer>", "<footer hidden>")])
