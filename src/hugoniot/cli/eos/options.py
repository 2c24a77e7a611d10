"""The arguments and options that several commands of `hugoniot eos` share."""

from pathlib import Path
from typing import Annotated

import typer

MATERIAL = Annotated[str, typer.Argument(metavar="MATERIAL", help="A library name or a TOML file.")]
MATERIALS = Annotated[list[str], typer.Argument(metavar="MATERIAL...", help="Library names or TOML files.")]
EXPLOSIVE = Annotated[str, typer.Argument(metavar="EXPLOSIVE", help="A library name or a TOML file with eos, unreacted and burn.")]
AT = Annotated[str | None, typer.Option("--at", help='A state on the Hugoniot: "pressure = 10 GPa", "particle_velocity = 500 m/s", '
                                                     '"shock_velocity = 6 km/s" or "density = 3 g/cm^3".')]
CSV = Annotated[Path | None, typer.Option("--csv", help="Write the numbers, in SI, to this file.")]
PLOT = Annotated[Path | None, typer.Option("--plot", help="Draw the picture into this file (.png, .pdf, .svg).")]
POINTS = Annotated[int, typer.Option("--points", min=2, max=100000, help="States along the curve.")]
HEAT = Annotated[str | None, typer.Option("--heat", help='Heat of reaction for a law without chemical energy, such as "6.27 MJ/kg".')]
DENSITY = Annotated[str | None, typer.Option("--density", help='Density of the unreacted explosive, such as "1.77 g/cm^3".')]
AHEAD = Annotated[str, typer.Option("--ahead", help='State ahead of the front, such as "density = 1.2 kg/m^3, pressure = 1 bar"; default: '
                                                    'at rest.')]
RATE = Annotated[str | None, typer.Option("--rate", help='A burn law instead of the material\'s: "pressure_power: rate_constant = 2e6 1/s, '
                                                         'pressure_exponent = 0, depletion_exponent = 0.5" (hugoniot list burn).')]
