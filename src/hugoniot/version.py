"""The version of the package, which every result states."""

__version__ = "0.1.0"
