"""What the material of a zone does in a step: passes over rows of zones that know neither dimension nor neighbours.

    closure     pressure and sound speed of an equation of state       mixture   the same of burning material, in its place
    strength    shear modulus, yield, plastic flow                      burn      burn fractions and rates
    fracture    damage, failure, voids                                  viscosity speed of the artificial viscosity
    laws        the laws of a material and what they ask for             steps     its passes, written down in the order of a step

A pass of a law is compiled once for that law, whatever it is combined with (`core.passes`); passes of geometry belong to the solvers.
"""
