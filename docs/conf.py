"""Builds the documentation: pages in Markdown, the gallery from examples/plot_*.py, reference pages from schema, registries and library."""

import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
NAMED = re.compile(r"(\S(?:\S| (?! ))*?) {2,}(\S.*)")      # a name, two blanks or more, its meaning
GENERATORS = ("generate_deck_reference.py", "generate_laws.py", "generate_theory.py", "materials/generate.py")

project = "hugoniot"
author = "The hugoniot developers"
copyright = "the hugoniot developers"
extensions = ["myst_nb", "sphinx_gallery.gen_gallery", "sphinx.ext.autodoc", "sphinx.ext.mathjax", "sphinx-mathjax-offline",
              "sphinx_copybutton", "sphinx_design"]
myst_enable_extensions = ["dollarmath", "colon_fence"]
myst_heading_anchors = 3
smartquotes = False
nb_execution_mode = "off"
exclude_patterns = ["_build", "**/generate*.py", "generate*.py", "verification_numbers.md", "theory/shock_structure_numbers.md",
                    "theory/lagrange1d_numbers.md",
                    "auto_examples/*.ipynb",
                    "auto_examples/*.py", "auto_examples/*.zip", "auto_examples/*.json", "**/sg_execution_times.rst"]
autodoc_typehints = "signature"
autodoc_member_order = "bysource"
copybutton_prompt_text = r"\$ |>>> "
copybutton_prompt_is_regexp = True
html_theme = "pydata_sphinx_theme"
html_title = "hugoniot"
html_theme_options = {"logo": {"text": "hugoniot"}, "navbar_align": "left", "show_toc_level": 2, "navigation_with_keys": False,
                      "show_prev_next": False, "secondary_sidebar_items": ["page-toc"], "footer_start": ["copyright"], "footer_end": []}
# a page without pages below it has nothing to list beside it
html_sidebars = {"*": [], "theory/*": []}
html_static_path = ["_static"]
html_css_files = ["house.css"]
html_js_files = ["sortable.js", "figures.js"]
html_show_sourcelink = False

sphinx_gallery_conf = {
    "examples_dirs": str(HERE.parent / "examples"),
    "gallery_dirs": "auto_examples",
    "filename_pattern": r"plot_",
    "copyfile_regex": r".*\.toml",
    "within_subsection_order": "FileNameSortKey",
    "download_all_examples": False,
    "show_signature": False,
    "abort_on_example_error": True,
    "write_computation_times": False,
    "min_reported_time": 1e9,
    "capture_repr": (),
    "image_scrapers": ("matplotlib",),
}


def generate(app) -> None:
    """Write the pages that are made from the package, each generator in a process of its own, before the sources are read."""
    for name in GENERATORS:
        subprocess.run([sys.executable, str(HERE / name)], check=True, stdout=subprocess.DEVNULL)


def plain_docstring(app, what, name, obj, options, lines) -> None:
    """The house's docstrings are plain text: names with their meanings become a list, what is aligned otherwise keeps its lines."""
    shown, named, rows = [], False, []
    for row in [*"\n".join(lines).strip("\n").splitlines(), ""]:
        found = None if row.startswith(">>>") else NAMED.match(row)
        if rows and (found or not row.strip() or (named and not row.startswith(" "))):     # what was before ends here
            shown += [*(rows if named else _block(rows)), ""]
            rows, named = [], False
        if found:
            rows, named = [f"``{found[1]}``", f"   {_plain(found[2])}"], True
        elif row.strip():
            rows.append(f"   {_plain(row.strip())}" if named else row)
    lines[:] = shown


def _block(rows: list[str]) -> list[str]:
    """Lines of text as a paragraph; lines with blanks inside, which align something, as they are."""
    if rows[0].startswith(">>>"):
        return [".. code-block:: pycon", "", *(f"   {row}" for row in rows)]
    if any("   " in row.strip() for row in rows):
        return [".. code-block:: text", "", *(f"   {row}" for row in rows)]
    if rows[0].startswith("$$") and rows[-1].endswith("$$"):
        return [".. math::", "", *(f"   {row.strip('$')}" for row in rows)]
    return [_plain(" ".join(row.strip() for row in rows))]


def _plain(text: str) -> str:
    """Text in which reStructuredText reads only what stands in backticks, as code, and between dollar signs, as a formula."""
    parts = re.split(r"(`+[^`]+`+|\$[^$]+\$)", text)
    read = [f":math:`{part.strip('$')}`" if part[:1] == "$" else f"``{part.strip('`')}``" for part in parts[1::2]]
    kept = [re.sub(r"([*|_\\])", r"\\\1", part) for part in parts[::2]]
    return "".join(part for pair in zip(kept, [*read, ""]) for part in pair)


def setup(app):
    app.connect("autodoc-process-docstring", plain_docstring)
    app.connect("builder-inited", generate, priority=100)
