"""The machine and the compiler for which code is compiled. Importing this module imports numba."""

import functools
import hashlib
import platform
import re
import sys

import llvmlite
import llvmlite.binding as llvm
import numba as nb


@functools.cache
def machine() -> dict[str, str]:
    """What decides the bits that a kernel computes, besides its sources: processor, its features, compiler, Python.

    Two machines with the same answer run the same machine code. The answer may be stored, in a checkpoint for instance.
    """
    config = nb.core.config
    features = config.CPU_FEATURES
    if features is None:
        features = ",".join(f"+{name}" for name, has in sorted(llvm.get_host_cpu_features().items()) if has)
    return {
        "cpu": config.CPU_NAME or llvm.get_host_cpu_name() or platform.machine(),
        "features": features,
        "system": llvm.get_process_triple(),
        "compiler": f"numba {nb.__version__}, llvmlite {llvmlite.__version__}, optimisation {config.OPT}, "
                    f"vector library {config.USING_SVML}, bounds checked {config.BOUNDSCHECK}",
        "python": f"{sys.implementation.name} {sys.version_info[0]}.{sys.version_info[1]}{getattr(sys, 'abiflags', '')}",
    }


@functools.cache
def machine_name() -> str:
    """A short name of `machine()` that is fit for a folder: the processor's name and a hash of the rest."""
    digest = hashlib.sha256(repr(sorted(machine().items())).encode()).hexdigest()
    return f"{re.sub(r'[^A-Za-z0-9]+', '-', machine()['cpu'])}-{digest[:12]}"
