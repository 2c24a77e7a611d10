"""Pieces of decks: regions of aluminium, and the laws of their material."""

EOS = """\
[material.al.eos]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5200 m/s"
s = 1.5
gamma0 = 2.0
"""
STRENGTH = """\
[material.al.strength]
law = "perfectly_plastic"
shear_modulus = "24.8 GPa"
yield_stress = "0.30 GPa"
"""
FRACTURE = """\
[material.al.fracture]
law = "spall_stress"
strength = "1.0 GPa"
"""


def region(name, start, end, zones, velocity=None):
    """A region of aluminium between two places, at rest or with a velocity."""
    moving = f'velocity = "{velocity}"\n' if velocity else ""
    return f'[[region]]\nname = "{name}"\nmaterial = "al"\nfrom = "{start}"\nto = "{end}"\nzones = {zones}\n{moving}'


def impact(flyer, target, start="2 mm", end="6 mm"):
    """A plate of 2 mm at 700 m/s and one at rest; `flyer` and `target` are their zones."""
    return region("flyer", "0 mm", "2 mm", flyer, "700 m/s") + region("target", start, end, target)


def gauge(name, at):
    """A gauge at a place."""
    return f'[[gauge]]\nname = "{name}"\nat = "{at}"\n'
