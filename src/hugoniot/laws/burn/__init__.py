"""Burn laws: importing this package enrols every law file of the folder."""

from hugoniot.core.registry import enrol_folder

enrol_folder(__name__, __path__)
