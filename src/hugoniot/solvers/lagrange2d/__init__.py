"""The two-dimensional Lagrangian solver."""
