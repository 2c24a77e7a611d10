"""The former address of binder, cache, compile_watch, inspection, mathematics, rows and target; goes with its last importer."""

# ruff: noqa: F401
from hugoniot.core.binder import bind, bind_choice, bind_dispatch, bind_family, bind_module
from hugoniot.core.mathematics import LAW
from hugoniot.core.rows import float_row, parameters, rows_apart
from hugoniot.core.target import EXACT_PASS, GUARD, INLINE, PASS, SWEEP
