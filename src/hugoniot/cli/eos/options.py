"""The arguments and options that several commands of `hugoniot eos` share."""

from pathlib import Path
from typing import Annotated

import typer

MATERIAL = Annotated[str, typer.Argument(metavar="MATERIAL", help="A name of the library or a TOML file.")]
MATERIALS = Annotated[list[str], typer.Argument(metavar="MATERIAL", help="Names of the library or TOML files.")]
EXPLOSIVE = Annotated[str, typer.Argument(metavar="EXPLOSIVE", help="A name of the library, or a TOML file with the tables eos, "
        "unreacted and burn.")]
AT = Annotated[str | None, typer.Option("--at", help='State on the Hugoniot, such as "pressure = 10 GPa", "particle_velocity = 500 m/s", '
                                                     '"shock_velocity = 6 km/s" or "density = 3 g/cm^3".')]
CSV = Annotated[Path | None, typer.Option("--csv", help="Write the numbers, in SI, to this file.")]
PLOT = Annotated[Path | None, typer.Option("--plot", help="Draw the picture into this file (.png, .pdf, .svg).")]
POINTS = Annotated[int, typer.Option("--points", min=2, max=100000, help="Number of states along the curve.")]
HEAT = Annotated[str | None, typer.Option("--heat", help='Heat of reaction per mass, for a law without chemical energy, such as '
        '"6.27 MJ/kg".')]
DENSITY = Annotated[str | None, typer.Option("--density", help='Density of the unreacted explosive, such as "1.77 g/cm^3".')]
AHEAD = Annotated[str, typer.Option("--ahead", help='State ahead of the front, such as "density = 1.2 kg/m^3, pressure = 1 bar" '
        '(default: the reference state).')]
RATE = Annotated[str | None, typer.Option("--rate", help='Burn law to use instead of that of the material, such as "pressure_power: '
        'rate_constant = 2e6 1/s, '
                                                         'pressure_exponent = 0, depletion_exponent = 0.5" (hugoniot list burn).')]
