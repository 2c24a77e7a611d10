"""Cells of two triangles: what no frame, mesh or geometry may change, the forces as derivatives of volumes, and what the pressure they share does."""

import dataclasses

import numpy as np
import pytest
from contact_builders import al, askew, meeting
from plane_builders import Boundary2D, Pulse, Viscosity2D, aluminium, box, gas, noh, problem, ran, walls
from test_plane_burning import gamma_products
from test_plane_invariance import EDGE, HERRMANN, SCHEMES, moving, strip_1d, twisted

from hugoniot.core import team
from hugoniot.diagnostics.gauges2d import Sampler
from hugoniot.errors import OutOfRange, UnphysicalState
from hugoniot.laws.fracture.spall_stress import SpallStress
from hugoniot.mesh.blocks import MeshError
from hugoniot.mesh.shapes import Curve, Edges
from hugoniot.mesh.triangles import DIAGONALS
from hugoniot.problem.model import Boundary
from hugoniot.problem.plane.model import Block2D, Gauge2D, Lighting2D, Rigid2D, VelocityField
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.plan import CORRECT, carry_out_alone
from hugoniot.solvers.lagrange2d.solver import Lagrange2D

TRIANGLES = {"cells": "triangles"}
