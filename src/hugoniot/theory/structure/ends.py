r"""The two end states of a shock: the exact jump of the same law that is used inside the shock.

In the frame of the shock the mass flux $m = \rho u$ is constant and states in balance without dissipation lie on the Rayleigh line

$$p = p_1 + m^2 (v_1 - v), \qquad e_R(v) = e_1 + p_1 (v_1 - v) + \tfrac12 m^2 (v_1 - v)^2 .$$

Both ends satisfy $p_{law}(v, e_R(v)) = p$ to round-off for any equation of state, without adjusting a constant of the law (Jordan eq.
7.1.31 adjusts Gamma for this).
"""

import math
from dataclasses import dataclass
from typing import Any

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.theory import hugoniot
from hugoniot.theory.states import law_of

_SAMPLES = 200


@dataclass(frozen=True)
class End:
    """One end state in the frame of the shock: kg/m3, J/kg, Pa, m/s, K (NaN where the law has no temperature), m/s."""

    density: float
    energy: float
    pressure: float
    velocity: float
    temperature: float
    sound_speed: float


@dataclass(frozen=True)
class Ends:
    """Upstream (1, supersonic) and downstream (2, subsonic) ends; mass_flux in kg/(m2 s); the gas flows towards +x."""

    eos: Any
    upstream: End
    downstream: End
    mass_flux: float

    @property
    def mach(self) -> float:
        return self.upstream.velocity / self.upstream.sound_speed

    @property
    def shock_velocity(self) -> float:
        """Speed of the shock into the material ahead, m/s."""
        return self.upstream.velocity

    @property
    def particle_velocity(self) -> float:
        """Velocity jump, m/s."""
        return self.upstream.velocity - self.downstream.velocity

    @property
    def entropy_jump(self) -> float:
        """Entropy gained across the shock, J/(kg K), from the law's own entropy; NaN where it has none."""
        if "entropy" not in EOS.of(self.eos).functions or not contract.has_temperature(self.eos):
            return math.nan
        one, two = self.upstream, self.downstream
        return float(contract.entropy(two.density, two.energy, self.eos) - contract.entropy(one.density, one.energy, self.eos))

    def rayleigh_energy(self, v: float) -> float:
        """e_R(v), J/kg."""
        one = self.upstream
        x = 1.0 / one.density - v
        return one.energy + one.pressure * x + 0.5 * (self.mass_flux * x) ** 2

    def excess(self, v: float) -> float:
        """Pressure of the law on the Rayleigh line above the line itself, Pa: zero at the ends, negative inside a shock."""
        one = self.upstream
        line = one.pressure + self.mass_flux**2 * (1.0 / one.density - v)
        return float(contract.pressure(1.0 / v, self.rayleigh_energy(v), self.eos)) - line


def find_ends(material, upstream: hugoniot.Initial | None = None, *, mach: float | None = None, **given) -> Ends:
    """The end states of a shock into `upstream` (default: the law's reference state).

    mach    shock velocity over the sound speed ahead, above 1; or exactly one of shock_velocity, particle_velocity (m/s), pressure (Pa),
            density (kg/m3) behind, as in `theory.hugoniot.shock`
    Raises `OutOfRange` for a Mach number at or below 1, `OutOfRange` or `NoSolution` where the law has no such shock.
    """
    par = law_of(material)
    ahead = upstream or hugoniot.Initial.at_rest(par)
    ahead = hugoniot.Initial(ahead.density, ahead.pressure, ahead.energy)
    contract.check_state(ahead.density, ahead.energy, par)
    c1 = float(contract.sound_speed(ahead.density, ahead.energy, par))
    if mach is not None:
        if given:
            raise OutOfRange(f"give the strength of a shock by mach or by {', '.join(given)}, not by both")
        if not (math.isfinite(mach) and mach > 1.0):
            raise OutOfRange(f"Mach {mach:g} is not a shock: its speed must be finite and exceed the sound speed ahead, {c1:.6g} m/s; "
                             "give a finite mach above 1")
        given = {"shock_velocity": mach * c1}
    if len(given) != 1:
        raise OutOfRange("a shock needs exactly one measure of strength (mach, shock_velocity, particle_velocity, pressure or density), "
                         "got "
                         + (", ".join(given) or "none"))
    name = EOS.of(par).name
    try:
        behind = hugoniot.shock(par, ahead, **given)
    except (OutOfRange, NoSolution) as error:
        raise type(error)(f"law '{name}' has no such shock: {error}") from None
    speed, rho2 = float(behind.shock_velocity), float(behind.density)
    if not (speed > c1 and rho2 > ahead.density and math.isfinite(speed)):
        raise OutOfRange(f"law '{name}' has no such shock: a compressive shock must be faster than sound ahead "
                         f"({c1:.6g} m/s), this one has {speed:.6g} m/s; try a stronger one")
    m = ahead.density * speed
    one = _end(par, ahead.density, ahead.energy, m)
    trial = Ends(par, one, one, m)
    v2 = _polished(trial, 1.0 / rho2)
    ends = Ends(par, one, _end(par, 1.0 / v2, trial.rayleigh_energy(v2), m), m)
    _require_one_wave(ends)
    return ends


def _end(par, rho, e, m) -> End:
    c2 = float(contract.sound_speed_squared(rho, e, par))
    T = float(contract.temperature(rho, e, par)) if contract.has_temperature(par) else math.nan
    if not c2 > 0.0:
        raise OutOfRange(f"law '{EOS.of(par).name}' has no such shock: it is unstable (c^2 = {c2:.4g} m2/s2) at rho = {rho:.6g} kg/m3, "
                         f"e = {e:.6g} J/kg; choose a weaker shock or another law")
    return End(float(rho), float(e), float(contract.pressure(rho, e, par)), m / rho, T, math.sqrt(c2))


def _polished(ends: Ends, v: float) -> float:
    """Secant steps on the excess from the jump's own search, kept only while they improve: the last digit of the downstream state."""
    best, miss = v, ends.excess(v)
    h = 1e-7 * (1.0 / ends.upstream.density - v)
    for _ in range(3):
        slope = (ends.excess(best + h) - ends.excess(best - h)) / (2.0 * h)
        if slope == 0.0:      # so weak a shock that round-off hides its excess
            break
        new = best - miss / slope
        trial = ends.excess(new)
        if not abs(trial) < abs(miss):
            break
        best, miss = new, trial
    return best


def _require_one_wave(ends: Ends) -> None:
    """A single steady wave needs the law's pressure below the Rayleigh line all the way, and subsonic flow behind."""
    v1, v2 = 1.0 / ends.upstream.density, 1.0 / ends.downstream.density
    name = EOS.of(ends.eos).name
    for i in range(1, _SAMPLES):
        v = v2 + (v1 - v2) * i / _SAMPLES
        if not ends.excess(v) < 0.0:
            raise NoSolution(f"law '{name}' has no such shock: no single steady one between {ends.upstream.density:.6g} and "
                             f"{ends.downstream.density:.6g} kg/m3: the Rayleigh line crosses its Hugoniot at {1.0 / v:.6g} kg/m3, "
                             "so the wave splits; try a shock below or above that density")
    if not ends.downstream.velocity < ends.downstream.sound_speed:
        raise NoSolution(f"law '{name}' has no such shock: the flow behind it is not subsonic, so it cannot be steady; try another "
                         "strength")
