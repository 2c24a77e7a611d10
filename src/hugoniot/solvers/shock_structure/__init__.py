"""The solver `shock_structure`: one-dimensional compressible Navier-Stokes flow of any equation of state, shocks resolved by viscosity."""
