"""How compiling is kept short. Importing this module imports numba and changes how it compiles in this process.

1. A function without wrappers that another kernel calls is only translated: numba would also optimise it and make machine code of it, then
   take its code into the caller and do both again, and once more with that one's caller. Here all the code of a kernel is optimised once,
   together. Where such a function's own address is asked for, it is finished then. It is not kept on disk. Whether a function is optimised
   before it is taken into its caller depends on its own options only, so that no result depends on what was compiled before.
2. No search for unreachable objects while a kernel is compiled: the compiler makes millions of objects that live until it is done.
3. Options of compiling are compared by what was set, which numba does a hundred thousand times for a march, with all options each time;
   and where all are asked for, they are not asked for one by one.
4. The variables of a statement are gathered into one list, without a list for each of its parts.
5. Nobody hears each time a function of LLVM is called: numba sums the time up for every function that is being compiled.
"""

import gc

from llvmlite import binding as llvm
from numba import _dynfunc
from numba.core import event, ir
from numba.core.caching import Cache
from numba.core.codegen import CPUCodeLibrary
from numba.core.compiler import CompileResult
from numba.core.compiler_lock import global_compiler_lock
from numba.core.cpu import CPUContext
from numba.core.environment import lookup_environment
from numba.core.targetconfig import ConfigStack, TargetConfig

ENVIRONMENT = "_ZN08NumbaEnv"       # how the names of variables begin in which functions look for their constants


# -- 1. functions inside others -----------------------------------------------------------------------------------------
def _is_inside(library, flags) -> bool:
    """Whether what is compiled with these options belongs to a kernel that is being compiled, and can be called by nobody else."""
    return not library._finalized and len(ConfigStack()) > 1 and flags.no_cpython_wrapper and flags.no_cfunc_wrapper


def _link(module, libraries) -> None:
    for library in dict.fromkeys(libraries):
        module.link_in(library._get_module_for_linking(), preserve=True)


def _optimise(library) -> None:
    """As numba does, but without machine code: with fast-math the last bits depend on what a caller finds here."""
    _link(library._final_module, library._linking_libraries)
    library._linking_libraries.clear()
    library._optimize_final_module()


def _executable(real):
    def get_executable(self, library, fndesc, env):
        flags = ConfigStack.top_or_none()
        if _is_inside(library, flags):
            if flags.fastmath:
                _optimise(library)
            return _dynfunc.make_function(fndesc.lookup_module(), fndesc.qualname.rpartition(".")[2], "inside a kernel", 0, env, (library,))
        executable = real(self, library, fndesc, env)
        # where the functions inside, which had no code of their own until now, look for their constants
        for name in (variable.name for variable in library._final_module.global_variables):
            if name.startswith(ENVIRONMENT) and (inner := lookup_environment(name)) is not None:
                library.codegen.set_env(name, inner)
        return executable

    return get_executable


def _linking(real):
    def add_linking_library(self, library):
        if library._finalized:
            real(self, library)
        else:
            self._linking_libraries.append(library)

    return add_linking_library


def _module(real):
    def _get_module_for_linking(self):
        if self._finalized:
            return real(self)
        if self._shared_module is None:
            self._shared_module = module = self._final_module.clone()
            _link(module, self._linking_libraries)
            for function in module.functions:
                if not function.is_declaration and function.linkage == llvm.Linkage.external:
                    function.linkage = "linkonce_odr"
        return self._shared_module

    return _get_module_for_linking


def _finishing(real):
    def _ensure_finalized(self):
        with global_compiler_lock:
            real(self)

    return _ensure_finalized


def _saving(real):
    def save_overload(self, sig, data):
        if not isinstance(data, CompileResult) or data.library._finalized:
            real(self, sig, data)

    return save_overload


CPUContext.get_executable = _executable(CPUContext.get_executable)
CPUCodeLibrary.add_linking_library = _linking(CPUCodeLibrary.add_linking_library)
CPUCodeLibrary._get_module_for_linking = _module(CPUCodeLibrary._get_module_for_linking)
CPUCodeLibrary._ensure_finalized = _finishing(CPUCodeLibrary._ensure_finalized)
Cache.save_overload = _saving(Cache.save_overload)


# -- 2. unreachable objects ------------------------------------------------------------------------------------------------
class _Collector(event.Listener):
    """Rests from the beginning of a kernel to its end, where it was at work before."""

    depth, rests = 0, False

    def on_start(self, event):
        if self.depth == 0 and gc.isenabled():
            self.rests = True
            gc.disable()
        self.depth += 1

    def on_end(self, event):
        self.depth -= 1
        if self.depth == 0 and self.rests:
            self.rests = False
            gc.enable()


event.register("numba:compile", _Collector())


# -- 3. options --------------------------------------------------------------------------------------------------------------
def _equal(self, other):
    if not isinstance(other, TargetConfig):
        return NotImplemented
    return self._values == other._values or _values(self) == _values(other)


def _values(self):
    """All options with their values, in order."""
    cls = type(self)
    if cls not in _defaults:
        _defaults[cls] = {name: option.default for name, option in cls.options.items()}
    return _defaults[cls] | self._values


_defaults: dict[type, dict] = {}
TargetConfig.__eq__ = _equal
TargetConfig.__hash__ = lambda self: 0      # numba's own is the same for all options too
TargetConfig.values = _values


# -- 4. variables of a statement ---------------------------------------------------------------------------------------------
def _gather(statement, value, found: list) -> None:
    kind = type(value)
    if kind is ir.Var:
        found.append(value)
    elif kind is dict:
        for part in value.values():
            _gather(statement, part, found)
    elif kind is list or kind is tuple:
        for part in value:
            _gather(statement, part, found)
    elif kind is ir.Expr:
        _gather(statement, value._kws, found)
    elif kind not in _WITHOUT:
        found += _numbas_own(statement, value)


def _variables(self, value):
    found: list = []
    _gather(self, value, found)
    return found


_WITHOUT = {ir.Loc, ir.Scope, str, int, float, bool, type(None)}
_numbas_own = ir.Inst._rec_list_vars
ir.Inst._rec_list_vars = _variables


# -- 5. who hears of LLVM's lock ---------------------------------------------------------------------------------------------
for _heard in list(getattr(getattr(llvm.ffi.lib, "_lock", None), "_cblist", ())):
    llvm.ffi.unregister_lock_callback(*_heard)
