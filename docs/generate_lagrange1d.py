"""Writes docs/theory/lagrange1d_numbers.md: what the one-dimensional solver does to shocks, spall and ends, measured.

    python docs/generate_lagrange1d.py                 # all, two minutes on one core
    python docs/generate_lagrange1d.py solids steps    # only these parts: fluids solids shocks steps spall liquid ends

The page is kept in the repository, unlike other generated pages: it is a record. Its numbers change with the step, the viscosity and
their defaults.
"""

import sys
from pathlib import Path

from generate_lagrange1d_ends import ends, liquid, spall
from generate_lagrange1d_shocks import fluids, shocks, solids, steps

TARGET = Path(__file__).parent / "theory" / "lagrange1d_numbers.md"
PARTS = {"Impacts of fluids": fluids, "Impacts of solids": solids, "Captured shocks": shocks, "Length of the step": steps,
         "Spall": spall, "A liquid against a gas": liquid, "Transmitting ends": ends}


def main(wanted) -> None:
    """Write the parts whose function is named in `wanted` (none: all) anew and keep the others."""
    old = dict(part.split("\n", 1) for part in ("\n" + TARGET.read_text()).split("\n### ")[1:]) if TARGET.exists() else {}
    text = []
    for title, part in PARTS.items():
        fresh = not wanted or part.__name__ in wanted or title not in old
        text += [f"### {title}", "", "\n".join(part()).strip() if fresh else old[title].strip(), ""]
    TARGET.write_text("\n".join(text).rstrip() + "\n")


if __name__ == "__main__":
    main(sys.argv[1:])
