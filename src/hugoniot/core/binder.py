"""Binds the plain scalar laws to compiled kernels: importing this module imports numba, so only kernel modules do.

Inside a kernel a call such as `pressure(rho, e, par)` is resolved by the class of `par`, at compile time, to that law's
own function and inlined. One kernel source therefore serves every law, each specialisation is compiled once and kept on
disk, and no closure or function pointer prevents vectorisation (`kernels/README.md`, items 3, 6, 7).

A law's functions are bound when a kernel first needs them, with every plain function they call, in any file. A law may therefore be
registered at any time, before or after its family was bound, and may have helpers in its own file or in another.
"""

import types as pytypes
from collections.abc import Callable, Iterator
from typing import Any

from numba.extending import overload

from hugoniot.core import ops
from hugoniot.core.mathematics import LAW
from hugoniot.core.registry import Registry

_OPERATION = "an operation of core.ops"
_COMPILERS_OWN = frozenset({"builtins", "math", "numba", "numpy", "operator"})   # packages whose functions the compiler knows

_bound: dict[Callable, object] = {f: _OPERATION for f in vars(ops).values() if isinstance(f, pytypes.FunctionType)}


def _claim(function, how) -> bool:
    """Whether `function` has yet to be bound, and this way; `ValueError` where it is bound in another way."""
    if function not in _bound:
        _bound[function] = how
        return True
    if _bound[function] != how:
        raise ValueError(f"{function.__module__}.{function.__qualname__} is bound to kernels already, as {_bound[function]}, "
                         f"and cannot be bound as {how} too")
    return False


def _bind(function, resolve):
    """Let kernels call `function` as the function `resolve` gives for the argument types, and that one what it calls."""
    def resolved(*args):
        chosen = resolve(*args)
        if chosen is not None:
            bind_callees(chosen)
        return chosen

    options = _bound[function] if isinstance(_bound[function], dict) else LAW
    overload(function, jit_options=options, strict=False)(resolved)


def bind(function, **options):
    """Let kernels call a plain scalar function through its undecorated name: inlined, or compiled with the given options.

    Without options a function that is bound stays as it is. Other options than those it is bound with are refused: which of the two
    a kernel gets would depend on what was imported first.
    """
    if (options or function not in _bound) and _claim(function, options or LAW):
        _bind(function, lambda *args: function)
    return function


def bind_module(module):
    """Bind every plain function of a module."""
    for value in list(vars(module).values()):
        if isinstance(value, pytypes.FunctionType) and value.__module__ == module.__name__:
            bind(value)


def bind_dispatch(generic, family: Registry, name: str, position: int = -1):
    """Resolve `generic(...)` inside kernels by the class of the parameter tuple at `position` among its arguments.

    `generic` is the plain function of the same meaning that dispatches in Python; `name` is the contract name.
    """
    def resolve(*args):
        cls = getattr(args[position], "instance_class", None)
        return None if cls is None else family.of_class(cls).functions.get(name)

    if _claim(generic, ("dispatch", family.family, name, position)):
        _bind(generic, resolve)


def bind_choice(generic, choose):
    """Resolve `generic(...)` inside kernels by the function `choose` returns for the argument classes (None where not a tuple).

    For what depends on facts about several laws at once, such as a flag of one and a function of another.
    """
    if _claim(generic, ("choice", choose.__code__)):
        _bind(generic, lambda *args: choose(*(getattr(arg, "instance_class", None) for arg in args)))


def only_if(chosen, otherwise=None):
    """Decorator: kernels have the function where `chosen` holds for the class of its last argument (None: no tuple); elsewhere nothing
    of it is compiled, and a call gives `otherwise`, None or a number."""
    def nothing(*args):
        return otherwise

    def choice(function):
        bind_choice(function, lambda *classes: function if chosen(classes[-1]) else nothing)
        return function

    return choice


def bind_family(family: Registry, generics: dict):
    """Bind a family's generic functions (contract name -> plain dispatching function); its laws follow when a kernel meets them."""
    for name, generic in generics.items():
        bind_dispatch(generic, family, name)


# -- what a function calls ---------------------------------------------------------------------------------------
def bind_callees(function) -> None:
    """Let a function that will be compiled call the plain functions it names, and so the kernels it calls; each once."""
    for kernel in (value.py_func for value in _named(function) if hasattr(value, "py_func")):
        bind_callees(kernel)
    for callee in _callees(function):
        if callee in _bound:
            continue
        families = [v for v in _named(callee) if isinstance(v, Registry)]
        if not families:
            bind(callee)
        elif names := [c for c in callee.__code__.co_consts if isinstance(c, str) and c in families[0].promises]:
            bind_dispatch(callee, families[0], names[0])    # a dispatching function of a contract whose family is not bound yet


def _callees(function) -> Iterator[pytypes.FunctionType]:
    """The plain functions that a function's code names and that the compiler does not know by itself."""
    for value in _named(function):
        if isinstance(value, pytypes.FunctionType) and value.__module__.partition(".")[0] not in _COMPILERS_OWN:
            yield value


def _named(function) -> list[Any]:
    """The objects that a function's code names: globals, attributes of modules, and what it encloses."""
    names = set(_names(function.__code__))
    values = [function.__globals__.get(name) for name in names]
    values += [cell.cell_contents for cell in function.__closure__ or ()]
    return values + [vars(module).get(name) for module in values if isinstance(module, pytypes.ModuleType) for name in names]


def _names(code) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, pytypes.CodeType):
            yield from _names(constant)
