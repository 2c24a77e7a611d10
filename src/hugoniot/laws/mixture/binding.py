"""Lets kernels call the mixture laws: one call for whoever compiles sweeps over burning zones."""


from hugoniot.laws.mixture.isentrope import integrated_energy, marched_energy


def _yes(par):
    return True


def _no(par):
    return False


def _by_march(v0, e0, v1, par):
    return marched_energy(v0, e0, v1, par)


def _by_integral(v0, e0, v1, par):
    return integrated_energy(v0, e0, v1, par)


def bind_mixtures() -> None:
    """Bind every mixture law, the equations of state beneath them and the generic functions of both contracts.

    The searches are bound without fast-math, because they compare residuals, and without forced inlining, because they are long; the
    equations of state inside them are inlined as everywhere. Imports numba.
    """
    from hugoniot.core import binder
    from hugoniot.laws.eos import contract as eos_contract
    from hugoniot.laws.mixture import contract, equilibrium, isentrope, isolated, two_state

    binder.bind_family(eos_contract.EOS, eos_contract.GENERICS)
    binder.bind_module(eos_contract)
    search = dict(fastmath=False, error_model="numpy", no_cfunc_wrapper=True)
    for function in (isentrope.stride, isentrope.marched_energy, isentrope.integrated_energy, isolated.equilibrate,
                     equilibrium.share_energy, equilibrium.coupled, equilibrium.nested, equilibrium.equilibrate, two_state.shared):
        binder.bind(function, **search)
    for function in (equilibrium.pull, equilibrium.reach):
        binder.bind(function, **search, forceinline=True)
    # sums whose terms may be added in any order, so that they are packed; what is no number stays none
    for function in (isentrope.brief_heating, isentrope.heating, isentrope.short_integral, isentrope.long_integral):
        binder.bind(function, fastmath={"contract", "reassoc", "nsz"}, error_model="numpy", no_cfunc_wrapper=True)

    for function in (isolated.attempt, equilibrium.attempt):
        binder.bind(function, fastmath={"contract", "reassoc", "nsz", "arcp"}, error_model="numpy", forceinline=True, no_cfunc_wrapper=True)

    def knows(*classes):
        return "reference_isentrope" in eos_contract.EOS.of_class(classes[-1]).functions

    binder.bind_choice(isentrope.knows_isentropes, lambda *classes: _yes if knows(*classes) else _no)

    def energy(*classes):
        if knows(*classes):
            return isentrope.closed_energy
        return _by_integral if "linear_in_energy" in eos_contract.EOS.of_class(classes[-1]).flags else _by_march

    binder.bind_choice(isentrope.isentrope_energy, energy)
    binder.bind_family(contract.MIXTURE, contract.GENERICS)
    binder.bind_module(contract)
