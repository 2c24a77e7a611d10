"""Binds the plain scalar laws to compiled kernels: importing this module imports numba, so only kernel modules do.

Inside a kernel a call such as `pressure(rho, e, par)` is resolved by the class of `par`, at compile time, to that law's
own function and inlined. One kernel source therefore serves every law, each specialisation is compiled once and kept on
disk, and no closure or function pointer stands in the way of the vectoriser (`kernels/README.md`, items 3, 6, 7).
"""

import sys
import types as pytypes

from numba.extending import overload

from hugoniot.core.mathematics import LAW
from hugoniot.core.registry import Registry

_bound: set = set()


def bind(function, **options):
    """Let kernels call a plain scalar function, inlined, through its undecorated name."""
    if function in _bound:
        return function
    _bound.add(function)
    overload(function, jit_options=options or LAW, strict=False)(lambda *args: function)
    return function


def bind_module(module):
    """Bind every plain function of a module, and the modules it imports functions from that declare `KERNEL_HELPERS = True`."""
    helpers = set()
    for value in list(vars(module).values()):
        if not isinstance(value, pytypes.FunctionType):
            continue
        if value.__module__ == module.__name__:
            bind(value)
        elif getattr(sys.modules[value.__module__], "KERNEL_HELPERS", False):
            helpers.add(value.__module__)
    for name in helpers:
        bind_module(sys.modules[name])


def bind_dispatch(generic, family: Registry, name: str, position: int = -1):
    """Resolve `generic(...)` inside kernels by the class of the parameter tuple at `position` among its arguments.

    `generic` is the plain function of the same meaning that dispatches in Python; `name` is the contract name.
    """
    if generic in _bound:
        return
    _bound.add(generic)

    def resolve(*args):
        cls = getattr(args[position], "instance_class", None)
        law = family.of_class(cls) if cls is not None else None
        return None if law is None else law.functions.get(name)

    overload(generic, jit_options=LAW, strict=False)(resolve)


def bind_choice(generic, choose):
    """Resolve `generic(...)` inside kernels by the function `choose` returns for the argument classes (None where not a tuple).

    For what depends on facts about several laws at once, such as a flag of one and a function of another.
    """
    if generic in _bound:
        return
    _bound.add(generic)

    def resolve(*args):
        return choose(*(getattr(arg, "instance_class", None) for arg in args))

    overload(generic, jit_options=LAW, strict=False)(resolve)


def bind_family(family: Registry, generics: dict):
    """Bind all law files of a family and its generic functions (contract name -> plain dispatching function)."""
    for name, generic in generics.items():
        bind_dispatch(generic, family, name)
    for law in family:
        bind_module(law.module)
