"""The Riemann problem of the solvers, for any equation of state: wave curves, contacts, walls, free surfaces, elastic precursors."""
