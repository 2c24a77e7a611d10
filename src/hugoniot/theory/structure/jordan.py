r"""The cases of Jordan 2011: argon, water and silica powders, with the readings of verification A5.

Jordan adjusts the Grüneisen parameter g so that the truncated equation of state

$$p = \rho_0c_0^2\,(x + 2s x^2 + 3 s^2 x^3) + g\,[\rho e - \rho_0 c_0^2 (x^2/2 + s x^3)], \qquad x = 1 - \rho_0/\rho,$$

satisfies the jump conditions. The formula (eq. 7.1.31) is missing from our copy and was rederived:

$$g = \frac{p_s - \rho_0c_0^2(x+2sx^2+3s^2x^3)}{\rho_s e_s - \rho_0c_0^2(x^2/2+sx^3)}, \qquad
  e_s = \frac{p_0}{g_{lit}\,\rho_0} + \frac{(p_s+p_0)\,x}{2\rho_0}, \qquad p_s = \rho_0 U_s u_p + p_0.$$

No profile of this package needs it: a Hugoniot-referenced law satisfies the jump conditions with any Grüneisen parameter.
"""

from dataclasses import dataclass

from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.transport import contract as transport_laws
from hugoniot.theory.hugoniot import Initial

GAS_CONSTANT, ARGON_DENSITY, ARGON_TEMPERATURE = 208.1, 1.62, 300.0  # Jordan section 6.3; 300 K is the temperature of mu (A5)
ARGON_VISCOSITY, ARGON_EXPONENT, ARGON_PRANDTL = 2.27e-5, 0.81, 2.0 / 3.0
ARGON_MACHS = (1.55, 3.38, 9.0)
AMBIENT = 101325.0

# block of table 6.2.1.1 -> (viscosity law, mean free path): A5, J-E4
ARGON_BLOCKS = {"constant": ("constant", "bsl"), "power_law": ("power_law", "chapman_enskog"), "maxwell": ("power_law", "bsl")}
# what the source prints at 19 200 cells: thickness (its unit), entropy (J/(kg K), J-E1); table 7.2.2 in m
TABLE_6_2_1_1 = {"constant": ((2.97, 0.56, 0.18), (16.52, 221.82, 685.23)), "power_law": ((5.79, 2.55, 3.15), (16.51, 223.06, 724.42)),
                 "maxwell": ((3.97, 1.75, 2.16), (16.49, 222.52, 719.09))}
TABLE_6_2_1_2 = {"thickness": (3.10, 0.72, 0.23), "entropy": (16.49, 224.55, 738.31)}
TABLE_7_2_2_ARGON = (419e-9, 184e-9, 228e-9)


def argon() -> tuple[IdealGas, Initial]:
    """Ideal-gas law of Jordan's argon (gamma 5/3, R 208.1) and its state ahead of the shock (1.62 kg/m3, 300 K)."""
    gamma = 5.0 / 3.0
    heat = GAS_CONSTANT / (gamma - 1.0)
    law = IdealGas(gamma, heat, ARGON_DENSITY)
    return law, Initial(ARGON_DENSITY, ARGON_DENSITY * GAS_CONSTANT * ARGON_TEMPERATURE, heat * ARGON_TEMPERATURE)


def argon_transport(law: str = "power_law", prandtl: float = ARGON_PRANDTL):
    """Argon's transport with a viscosity law "constant", "power_law", "sutherland", "hard_sphere" or "maxwell_molecules", all 2.27e-5 Pa s
    at 300 K (the sphere's diameter is chosen to give that), and a Prandtl number."""
    mu, T = ARGON_VISCOSITY, ARGON_TEMPERATURE
    tables = {"constant": {}, "power_law": {"exponent": ARGON_EXPONENT, "reference_temperature": T},
              "sutherland": {"reference_temperature": T, "sutherland_temperature": 144.4},
              "maxwell_molecules": {"reference_temperature": T}}
    if law == "hard_sphere":
        mass = 6.6335e-26
        unit = transport_laws.make({"law": law, "molecular_mass": mass, "diameter": 1.0}).shear
        diameter = (transport_laws.viscosity(ARGON_DENSITY, T, unit) / mu) ** 0.5
        shear = {"law": law, "molecular_mass": mass, "diameter": diameter}
    else:
        shear = {"law": law, "shear_viscosity": mu, **tables[law]}
    return transport_laws.make(shear, {"law": "prandtl", "prandtl": prandtl})


@dataclass(frozen=True)
class CondensedCase:
    """A row of Jordan's tables 7.1.1 and 7.2.1 with its slips corrected (J-E10): SI; `bent` is the source's adjusted Grüneisen parameter,
    `spacing` its h_x times its length unit, m, `printed` the thickness it gives, m (low and high)."""

    name: str
    density: float
    sound_speed: float
    slope: float
    bent: float
    literature: float
    particle_velocity: float
    shear_viscosity: float
    prandtl: float
    specific_heat: float
    spacing: float
    printed: tuple[float, float]

    def eos(self, gamma0: float | None = None) -> MieGruneisen:
        """Hugoniot-referenced Mie-Grüneisen law; gamma0 default: the bent value, which this law does not need."""
        return MieGruneisen(self.density, self.sound_speed, self.slope, self.bent if gamma0 is None else gamma0, self.specific_heat)

    def transport(self, conducting: bool = False):
        """Constant viscosity, no bulk viscosity; with heat conduction by the case's Prandtl number if asked."""
        return transport_laws.make({"law": "constant", "shear_viscosity": self.shear_viscosity},
                                   {"law": "prandtl", "prandtl": self.prandtl} if conducting else None)


_WATER = dict(density=1000.0, sound_speed=1450.0, slope=1.99, literature=0.15, shear_viscosity=1.003e-3, prandtl=7.01, specific_heat=1385.0)
_SILICA = dict(specific_heat=86.2, spacing=0.25 * 1.61e-10)
CONDENSED = {case.name: case for case in (
    CondensedCase("water_387", bent=2.8381831, particle_velocity=387.5, spacing=12.5 * 6.2e-10, printed=(310e-9, 310e-9), **_WATER),
    CondensedCase("water_858", bent=2.9543413, particle_velocity=858.0, spacing=25.0 * 6.2e-10, printed=(868e-9, 868e-9), **_WATER),
    CondensedCase("silica_100", 100.0, 121.0, 0.9736, 0.1918117, 0.3, 934.0, 4.40e-5, 0.91, printed=(1.6e-9, 16e-9), **_SILICA),
    CondensedCase("silica_250", 250.0, 97.0, 1.2509, 0.7240199, 0.3, 770.0, 1.10e-4, 2.27, printed=(4.0e-9, 16e-9), **_SILICA),
    CondensedCase("silica_770", 770.0, 1070.9, 0.4045, 0.1016222, 0.3, 704.0, 3.39e-4, 7.00, printed=(8.1e-9, 32e-9), **_SILICA),
)}


def adjusted_gruneisen(density, sound_speed, slope, literature, particle_velocity, ambient=AMBIENT) -> float:
    """The Grüneisen parameter Jordan would use to make the truncated law fit the jump (eq. 7.1.31, restored; see the module)."""
    shock = sound_speed + slope * particle_velocity
    p = density * shock * particle_velocity + ambient
    x = particle_velocity / shock
    rho = density / (1.0 - x)
    e = ambient / (literature * density) + 0.5 * (p + ambient) * x / density
    stiffness = density * sound_speed**2
    return ((p - stiffness * (x + 2.0 * slope * x**2 + 3.0 * slope**2 * x**3))
            / (rho * e - stiffness * (0.5 * x**2 + slope * x**3)))
