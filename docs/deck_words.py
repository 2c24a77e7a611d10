"""The texts of the deck reference (`generate_deck_reference`) that stand before and between its tables."""

INTRODUCTION = """\
# Deck reference

A deck is a text file in the [TOML](https://toml.io) format that describes one simulation: bodies, materials, boundaries, solver and
output. This page lists every table and key that a deck may have, except those of `[sweep]`. The shortest deck has a stop time and one
region. In the following complete deck a copper plate strikes an aluminium plate:

```toml
stop_time = "1 us"

[[region]]
name = "flyer"
material = "copper"          # a material of the library
from = "0 mm"
to = "2 mm"
zones = 200
velocity = "500 m/s"

[[region]]
name = "target"
material = "aluminum"
from = "2 mm"
to = "6 mm"
zones = 400
```

Saved as `impact.toml`, it is checked by `hugoniot check impact.toml` and run by `hugoniot run impact.toml`. `hugoniot init` lists commented
decks to start from.

* **Tables.** `[solver]` starts a table that occurs once. `[[region]]` starts one of several tables of the same name (type "tables").
  A small table can also be written in braces: `{law = "constant", shear_viscosity = "1 mPa s"}`.
* **Quantities.** A quantity is a string with a unit, such as `"3.94 km/s"`, `"2.7 g/cm^3"` or `"25 GPa"`. A bare number is in the SI unit
  given in the column "type". A number without a unit in that column is dimensionless.
* **Defaults.** A key without an entry in the column "default" is optional and has no effect if omitted, unless its meaning says when it is
  required.
* **Conditions.** Some meanings begin with a condition and a colon, such as "sector:" (a value of `shape`). The key then applies only under
  that condition.
* **Errors.** Unknown keys, wrong units and contradictions are errors. All errors of a deck are reported together, each with its line.
* **Solvers.** `kind` in `[solver]` chooses the solver. [`lagrange1d`](#decks-of-lagrange1d) is the default. The others,
  [`fronts`](#decks-of-fronts), [`shock_structure`](#decks-of-shock_structure) and [`lagrange2d`](#decks-of-lagrange2d), share only part of
  its keys.
* **Editors.** `hugoniot init --schema` writes a JSON Schema, with which text editors complete and check decks.
  `hugoniot check DECK --resolved` prints a deck with every default written out.
* **Sweeps.** A deck with a table `[sweep]` works with [`hugoniot sweep`](../campaigns.md#sweeps) only; other commands refuse it.
"""
MATERIALS = """\
## Materials

A region or block names its material. A table `[material.NAME]` of the deck has precedence, and replaces the whole material of that name
in the library; otherwise the name, or an alias of it, is looked up in [your material files](../materials/users.md) and in the library
(`hugoniot material list`). A material needs an equation of state, or a `base`:

```toml
[material.al]                # replaces the fracture law of the library's aluminium, and one number of its strength law
base = "al6061"
fracture = "none"

[material.al.strength]
yield_stress = "0.30 GPa"

[material.mine.eos]          # a new material
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5200 m/s"
s = 1.5
gamma0 = 2.0
```

With `base`, a law table without `law`, or with the same law, changes only the numbers that it gives. A table with another law replaces the
whole law. The laws and their parameters are listed [below](#laws).

### [material.NAME]

"""
BOUNDARIES = """\
## Boundaries and pulses

In one dimension `left` and `right` of `[boundary]` take one of these values:

* `"free"`: a free surface. This is the default, except at the axis or centre of curved geometry, where nothing needs to be given.
* `"fixed"`: a rigid wall.
* `"transmitting"`: waves leave almost without reflection.
* `"periodic"`: what leaves at one end enters at the other. Both ends must be periodic, the geometry planar, and no material may burn.
* `{velocity = ...}`: the end moves with this velocity, positive to the right.
* `{pressure = ...}`: this pressure acts on the end, positive in compression.

Wherever a type includes "or pulse", the value is a quantity (constant from the start), a pulse
`{shape = "half_sine", amplitude = "2 GPa", duration = "1 us"}`, or a table of times `{times = ["0 us", "1 us"], values = ["2 GPa", 0]}`.
"""
LAWS = """\
## Laws

A law is chosen by `law = "..."` in its table. "law" in the column "unit" means that the parameter is itself an equation of state, given as
a table or as the name of a material of the library. A parameter without a unit is dimensionless or a text.
"""
