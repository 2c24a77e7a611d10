"""Laws over arrays: the same scalar laws, swept by compiled loops (or by plain Python for a few states).

    pressure_array(rho, e, par)        Pa
    derivatives_array(rho, e, par)     (dp/drho at constant e, dp/de at constant rho)
    sound_speed_array(rho, e, par)     m/s; NaN where the state is unstable
    temperature_array(rho, e, par)     K
    recorded_temperature(rho, e, par, compaction)   K, of the states of a run
    entropy_array(rho, e, par)         J/(kg K)
    energy_array(rho, p, par)          J/kg
    shear_modulus_array(rho, p, temperature, bulk_modulus, par)   Pa, of a strength law
    evaluate(par, rho, e, *names)      dictionary of any of QUANTITIES

`rho` (kg/m3) and `e` (J/kg) broadcast; results have the broadcast shape. States are not checked (laws.eos.contract.check_state does that
for one). Up to SMALL states are evaluated in Python, so that short curves need neither numba nor a compilation.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.strength.contract import shear_modulus

SMALL = 256
WORTH_COMPILING = 4096     # states: the shear modulus is asked for once a snapshot, and a first run need not wait for the compiler
QUANTITIES = ("pressure", "pressure_derivatives", "sound_speed_squared", "sound_speed", "gruneisen", "bulk_modulus", "adiabatic_exponent",
              "temperature", "entropy", "specific_heat")


def float_parameters(par):
    """The same parameters with every number a float: an integer would make the compiler specialise once more."""
    fields = [float_parameters(v) if isinstance(v, tuple) else float(v) if isinstance(v, (int, np.number)) else v for v in par]
    return type(par)(*fields) if hasattr(par, "_fields") else tuple(fields)


def _states(rho, e):
    rho, e = np.broadcast_arrays(np.asarray(rho, dtype=np.float64), np.asarray(e, dtype=np.float64))
    return np.ascontiguousarray(rho).ravel(), np.ascontiguousarray(e).ravel(), rho.shape


def _sweep(name, rho, e, par):
    """One quantity of one value per state by the sweep `<name>_sweep`, or by Python for a few states."""
    if name not in ("pressure", "sound_speed_squared") and not contract.gives(par, name):
        raise OutOfRange(f"{EOS.of(par).name}: this equation of state gives no {name.replace('_', ' ')}")
    rho, e, shape = _states(rho, e)
    out = np.empty(rho.size)
    if rho.size <= SMALL:
        function, par = getattr(contract, name), float_parameters(par)
        with np.errstate(all="ignore"):
            for j in range(rho.size):
                out[j] = function(rho[j], e[j], par)
    else:
        from hugoniot.laws import array_kernels

        getattr(array_kernels, f"{name}_sweep")(rho, e, float_parameters(par), out)
    return out.reshape(shape)[()]


def pressure_array(rho, e, par):
    """Pressure, Pa."""
    return _sweep("pressure", rho, e, par)


def derivatives_array(rho, e, par):
    """(dp/drho at constant e, Pa m3/kg; dp/de at constant rho, Pa kg/J)."""
    rho, e, shape = _states(rho, e)
    p_rho, p_e = np.empty(rho.size), np.empty(rho.size)
    if rho.size <= SMALL:
        par = float_parameters(par)
        with np.errstate(all="ignore"):
            for j in range(rho.size):
                p_rho[j], p_e[j] = contract.pressure_derivatives(rho[j], e[j], par)
    else:
        from hugoniot.laws import array_kernels

        array_kernels.derivatives_sweep(rho, e, float_parameters(par), p_rho, p_e)
    return p_rho.reshape(shape)[()], p_e.reshape(shape)[()]


def sound_speed_squared_array(rho, e, par):
    """c^2, m2/s2 (negative where the state is unstable)."""
    return _sweep("sound_speed_squared", rho, e, par)


def sound_speed_array(rho, e, par):
    """Bulk sound speed, m/s; NaN where the state is unstable."""
    with np.errstate(invalid="ignore"):
        return np.sqrt(sound_speed_squared_array(rho, e, par))


def temperature_array(rho, e, par):
    """Temperature, K; OutOfRange where the law has none."""
    contract.require_temperature(par)
    return _sweep("temperature", rho, e, par)


def recorded_temperature(rho, e, par, compaction=None):
    """Temperature, K, of states of a run: the same bits for a state in any company, for how many are evaluated at once is chance.

    Always compiled, state by state, however few they are. `compaction`, of the shape of the states, is the history of a law with memory.
    """
    from hugoniot.laws import array_kernels

    contract.require_temperature(par)
    rho, e, shape = _states(rho, e)
    out = np.empty(rho.size)
    if "remembers" in EOS.of(par).flags and compaction is not None:
        array_kernels.remembered_temperature_rows(rho, e, np.ascontiguousarray(compaction, float).ravel(), float_parameters(par), out)
    else:
        array_kernels.recorded_temperature_rows(rho, e, float_parameters(par), out)
    return out.reshape(shape)[()]


def entropy_array(rho, e, par):
    """Specific entropy, J/(kg K), up to a constant; OutOfRange where the law has none."""
    contract.require_temperature(par)
    return _sweep("entropy", rho, e, par)


def energy_array(rho, p, par):
    """Specific internal energy at densities and pressures, J/kg; OutOfRange where the law has no closed inverse."""
    return _sweep("energy", rho, p, par)


def shear_modulus_array(rho, p, temperature, bulk_modulus, par):
    """Shear modulus of a strength law, Pa, (n,), at densities kg/m3, pressures Pa, temperatures K (0 where the law asks for none) and
    bulk moduli Pa."""
    rho, p, temperature, bulk = (np.ascontiguousarray(given) for given in np.broadcast_arrays(
        *(np.asarray(given, dtype=np.float64) for given in (rho, p, temperature, bulk_modulus))))
    par, out = float_parameters(par), np.empty(rho.size)
    if rho.size <= WORTH_COMPILING:
        for j in range(rho.size):
            out[j] = shear_modulus(rho[j], p[j], temperature[j], bulk[j], par)
    else:
        from hugoniot.laws import array_kernels

        array_kernels.shear_modulus_sweep(rho, p, temperature, bulk, par, out)
    return out


def evaluate(par, rho, e, *names):
    """{name: array} of the named QUANTITIES at the states (rho, e); "pressure_derivatives" gives a pair."""
    found = {}
    for name in names:
        if name == "pressure_derivatives":
            found[name] = derivatives_array(rho, e, par)
        elif name == "sound_speed":
            found[name] = sound_speed_array(rho, e, par)
        elif name == "gruneisen":
            found[name] = derivatives_array(rho, e, par)[1] / rho
        elif name == "bulk_modulus":
            found[name] = rho * sound_speed_squared_array(rho, e, par)
        elif name == "adiabatic_exponent":
            found[name] = rho * sound_speed_squared_array(rho, e, par) / pressure_array(rho, e, par)
        elif name == "specific_heat":
            contract.require_temperature(par)
            found[name] = _small_only("specific_heat", rho, e, par)
        elif name in ("temperature", "entropy"):
            found[name] = temperature_array(rho, e, par) if name == "temperature" else entropy_array(rho, e, par)
        elif name in QUANTITIES:
            found[name] = _sweep(name, rho, e, par)
        else:
            raise OutOfRange(f"unknown quantity '{name}'; known: {', '.join(QUANTITIES)}")
    return found


def _small_only(name, rho, e, par):
    """A quantity nobody sweeps in bulk, state by state."""
    rho, e, shape = _states(rho, e)
    function, par = EOS.of(par).functions[name], float_parameters(par)
    return np.array([function(r, u, par) for r, u in zip(rho, e)]).reshape(shape)[()]
