"""One row per field of a state: symbol, name, unit, location. Files, gauges, plot labels, decks and docs all use these names."""

from typing import NamedTuple


class Field(NamedTuple):
    """place: "zone" or "node"; `unit` is the SI unit; `long_name` labels plots and files; `display` (unit, factor) for pictures."""

    name: str
    symbol: str
    unit: str
    place: str
    long_name: str
    display: tuple[str, float]


_ROWS = (
    Field("position", "r", "m", "node", "position", ("mm", 1e3)),
    Field("velocity", "u", "m/s", "node", "particle velocity", ("m/s", 1.0)),
    Field("position_x", "x", "m", "node", "position along x (radius in axisymmetric geometry)", ("mm", 1e3)),
    Field("position_y", "y", "m", "node", "position along y (z in axisymmetric geometry)", ("mm", 1e3)),
    Field("velocity_x", "u_x", "m/s", "node", "particle velocity along x (radial in axisymmetric geometry)", ("m/s", 1.0)),
    Field("velocity_y", "u_y", "m/s", "node", "particle velocity along y (axial in axisymmetric geometry)", ("m/s", 1.0)),
    Field("contact_pressure", "p_c", "Pa", "node", "contact pressure", ("GPa", 1e-9)),
    Field("gap", "g", "m", "node", "distance to the nearest other body", ("mm", 1e3)),
    Field("sliding_distance", "d_s", "m", "node", "distance slid along other bodies", ("mm", 1e3)),
    Field("density", "rho", "kg/m^3", "zone", "density", ("kg/m³", 1.0)),
    Field("energy", "e", "J/kg", "zone", "specific internal energy", ("kJ/kg", 1e-3)),
    Field("pressure", "p", "Pa", "zone", "pressure", ("GPa", 1e-9)),
    Field("viscous_pressure", "q", "Pa", "zone", "artificial viscous pressure", ("GPa", 1e-9)),
    Field("deviator_radial", "s1", "Pa", "zone", "longitudinal stress deviator (tension positive)", ("GPa", 1e-9)),
    Field("deviator_hoop", "s2", "Pa", "zone", "hoop stress deviator (tension positive)", ("GPa", 1e-9)),
    Field("deviator_xx", "s_xx", "Pa", "zone", "stress deviator along x (tension positive)", ("GPa", 1e-9)),
    Field("deviator_yy", "s_yy", "Pa", "zone", "stress deviator along y (tension positive)", ("GPa", 1e-9)),
    Field("deviator_xy", "s_xy", "Pa", "zone", "shear stress in the plane", ("GPa", 1e-9)),
    Field("deviator_zz", "s_zz", "Pa", "zone", "stress deviator out of the plane, the hoop in axisymmetric geometry (tension positive)",
          ("GPa", 1e-9)),
    Field("von_mises", "sigma_e", "Pa", "zone", "von Mises stress", ("GPa", 1e-9)),
    Field("principal_angle", "phi", "rad", "zone", "direction of the most tensile principal stress in the plane, from x", ("rad", 1.0)),
    Field("lode_angle", "theta_L", "rad", "zone", "Lode angle", ("rad", 1.0)),
    Field("stress", "sigma", "Pa", "zone", "longitudinal stress (compression positive)", ("GPa", 1e-9)),
    Field("sound_speed", "c", "m/s", "zone", "longitudinal sound speed", ("m/s", 1.0)),
    Field("temperature", "T", "K", "zone", "temperature", ("K", 1.0)),
    Field("plastic_strain", "eps_p", "1", "zone", "equivalent plastic strain", ("", 1.0)),
    Field("damage", "D", "1", "zone", "fracture damage", ("", 1.0)),
    Field("void_fraction", "phi", "1", "zone", "volume fraction of voids opened in fracture", ("", 1.0)),
    Field("compaction", "k", "1", "zone", "compaction (0: pores uncompacted, 1: pores closed)", ("", 1.0)),
    Field("burn_fraction", "lambda", "1", "zone", "burn fraction", ("", 1.0)),
    Field("reference_state", "k_r", "1", "zone", "shock of the reactants (0 none yet, 1 passing, 2 passed, 3 passed while burning)",
          ("", 1.0)),
    Field("eroded", "D_e", "1", "zone", "1 if the zone was removed from the mesh, else 0", ("", 1.0)),
    Field("plastic_work", "w_p", "J/kg", "zone", "plastic work", ("kJ/kg", 1e-3)),
    Field("viscous_work", "w_q", "J/kg", "zone", "work of the artificial viscosity", ("kJ/kg", 1e-3)),
    Field("kinetic_energy", "e_k", "J/kg", "zone", "kinetic energy", ("kJ/kg", 1e-3)),
    Field("momentum", "m_u", "kg m/s", "zone", "momentum of the zone (planar: per m^2, cylindrical: per m and radian, spherical: "
        "per steradian)", ("kg m/s", 1.0)),
    Field("momentum_x", "m_x", "kg m/s", "zone", "momentum of the zone along x (plane: per m, axisymmetric: per radian)", ("kg m/s", 1.0)),
    Field("momentum_y", "m_y", "kg m/s", "zone", "momentum of the zone along y (plane: per m, axisymmetric: per radian)", ("kg m/s", 1.0)),
    Field("elastic_deviator_energy", "e_d", "J/kg", "zone", "elastic energy of distortion", ("kJ/kg", 1e-3)),
    Field("pressure_work_and_heat", "w", "J/kg", "zone", "work of the pressure and heat received since the start", ("kJ/kg", 1e-3)),
    Field("entropy", "eta", "J/kg/K", "zone", "specific entropy, up to a constant of the material", ("J/kg/K", 1.0)),
    Field("mass", "m", "kg", "zone", "mass of the zone (planar: per m^2, cylindrical: per m and radian, spherical: per steradian; "
        "plane: per m, axisymmetric: per radian)", ("kg", 1.0)),
)

FIELDS = {row.name: row for row in _ROWS}
