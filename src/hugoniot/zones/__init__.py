"""The response of the material of a zone in a step: passes over rows of zones, independent of dimension and neighbours.

    closure     pressure and sound speed of an equation of state       mixture   the same of burning material, in its place
    strength    shear modulus, yield, plastic flow                      burn      burn fractions and rates
    fracture    damage, failure, voids                                  viscosity speed of the artificial viscosity
    laws        the laws of a material and what they need                steps     its passes, in the order of a step

A pass of a law is compiled once for that law in all combinations (`core.passes`); passes of geometry belong to the solvers.
"""
