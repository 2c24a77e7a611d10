"""The command `hugoniot`: which commands there are, and how every one of them ends.

Only the module of the command that is called gets imported; the others are known by the one line of help kept here, so
`hugoniot --help` answers at once. A command module holds `app`, a typer application, or a function `command` (or of its own name).

Exit codes: 0 done, 1 a defect of the program, 2 deck or command line, 3 physics, 4 files, 130 interrupted.
"""

import functools
import os
import sys
import traceback
from collections.abc import Callable
from types import ModuleType
from typing import Annotated

import typer
from typer.core import TyperCommand

from hugoniot.cli.typed import remember
from hugoniot.errors import HugoniotError

# name -> the line shown by `hugoniot --help`
COMMANDS: dict[str, str] = {
    "init": "Write a commented deck for a common problem.",
    "check": "Report all errors and warnings in a deck.",
    "run": "Run a deck and write its run folder.",
    "resume": "Continue an interrupted run from its last checkpoint.",
    "info": "Print a summary of a run.",
    "plot": "Draw a picture of a run.",
    "animate": "Write a film of a two-dimensional run.",
    "compare": "Compare two runs, or a run and measured data.",
    "report": "Write report.html of a run again.",
    "sweep": "Run a deck many times with some of its keys varied.",
    "fit": "Find constants of a deck from measured records.",
    "verify": "Run the built-in standard problems.",
    "material": "Search and show the materials library.",
    "import": "Convert decks of pyKO and KO, and materials of LS-DYNA.",
    "eos": "Hugoniots, isentropes, impedance matches, detonations.",
    "exact": "Exact solutions, such as Noh, Sedov and Guderley.",
    "pop-plot": "Compute the Pop plot of an explosive.",
    "fit-rate": "Fit constants of a burn law to a measured Pop plot.",
    "structure": "Compute the internal structure of a shock.",
    "explore": "Explore materials, runs and decks in a browser.",
    "list": "List laws, materials, fields, problems and solvers.",
}


def module_of(name: str) -> ModuleType:
    """The module of a command, imported now."""
    match name:
        case "init":
            from hugoniot.cli import init as module
        case "check":
            from hugoniot.cli import check as module
        case "run":
            from hugoniot.cli import run as module
        case "resume":
            from hugoniot.cli import resume as module
        case "info":
            from hugoniot.cli import info as module
        case "plot":
            from hugoniot.cli import plot as module
        case "animate":
            from hugoniot.cli import animate as module
        case "compare":
            from hugoniot.cli import compare as module
        case "report":
            from hugoniot.cli import report as module
        case "sweep":
            from hugoniot.cli import sweep as module
        case "fit":
            from hugoniot.cli import fit as module
        case "verify":
            from hugoniot.cli import verify as module
        case "material":
            from hugoniot.cli import material as module
        case "import":
            from hugoniot.cli import import_cards as module
        case "eos":
            from hugoniot.cli.eos import app as module
        case "exact":
            from hugoniot.cli import exact as module
        case "pop-plot":
            from hugoniot.cli import pop_plot as module
        case "fit-rate":
            from hugoniot.cli import fit_rate as module
        case "structure":
            from hugoniot.cli import structure as module
        case "explore":
            from hugoniot.cli import explore as module
        case "list":
            from hugoniot.cli import listing as module
        case _:
            raise KeyError(name)
    return module


COMPLETE = "_HUGONIOT_COMPLETE"
VALUES = {"path": "PATH", "int": "NUMBER", "float": "NUMBER"}     # what a value of an option is called in the help; any other is a TEXT


class Command(TyperCommand):
    """A command whose help names values and arguments as manuals do (TEXT, DECK), not by the types of the program."""

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        for parameter in self.params:
            if parameter.param_type_name == "argument":
                parameter.metavar = parameter.metavar or str(parameter.name).upper()
                several = "..." if parameter.nargs != 1 else ""
                shown = parameter.metavar + several if parameter.required else f"[{parameter.metavar}]{several}"
                parameter._usage_display_name = lambda shown=shown: shown       # recent versions of typer write {DECK}
                parameter.display_type_rich = lambda ctx: None                  # and DECK <path>
            elif parameter.metavar is None and not getattr(parameter, "is_flag", False) and not getattr(parameter, "count", False):
                parameter.metavar = _called_in_help(parameter)

    def invoke(self, ctx):
        """Run the command, which may then ask what was typed."""
        remember(name for p in self.params if getattr(ctx.get_parameter_source(p.name), "name", "") == "COMMANDLINE"
                 for name in (p.secondary_opts if ctx.params[p.name] is False and p.secondary_opts else p.opts))
        return super().invoke(ctx)


def _called_in_help(option) -> str:
    """TEXT, PATH or NUMBER."""
    kind = option.display_type(None) if hasattr(option, "display_type") else str(getattr(option.type, "name", ""))
    return next((word for name, word in VALUES.items() if name in kind.lower()), "TEXT")


def build_app(wanted: str | None) -> typer.Typer:
    """The application with the module of one command loaded and the others present by name only."""
    app = typer.Typer(
        name="hugoniot", no_args_is_help=True, add_completion=True, pretty_exceptions_enable=False, rich_markup_mode=None,
        help="A shock-physics workbench: simulations, equations of state, materials and exact solutions.\n\nFirst steps: hugoniot "
        "init flyer, then hugoniot run flyer.toml. The input file flyer.toml is called a deck.",
        epilog="hugoniot COMMAND --help explains a command, with an example.", context_settings={"help_option_names": ["-h", "--help"]})
    app.callback()(_options)
    for name, line in COMMANDS.items():
        if name == wanted:
            _mount(app, name, module_of(name), line)
        else:
            app.command(name, help=line)(_only_listed)
    return app


def _only_listed() -> None:
    """Stands for a command that was not called: its name and its line are all that is shown of it."""


def _mount(app: typer.Typer, name: str, module, line: str) -> None:
    if not hasattr(module, "app"):
        function = getattr(module, "command", None) or getattr(module, name)
        app.command(name, cls=Command, help=(function.__doc__ or line).strip(), short_help=line)(guarded(function))
        return
    sub: typer.Typer = module.app
    for info in sub.registered_commands:
        plain = getattr(info.callback, "__wrapped__", info.callback)    # an application may be built again in the same process
        info.callback = guarded(plain)  # type: ignore[arg-type]
        info.cls = Command
    sub.info.rich_markup_mode = None  # type: ignore[attr-defined]
    app.add_typer(sub, name=name, short_help=line)


def _version(wanted: bool) -> None:
    if wanted:
        from hugoniot.version import __version__
        typer.echo(f"hugoniot {__version__}")
        raise typer.Exit()


VERSION = Annotated[bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")]


def _options(version: VERSION = False) -> None:
    pass


def guarded(function: Callable) -> Callable:
    """A command that ends with one clear message and the right exit code, whatever happens in it."""

    @functools.wraps(function)
    def call(*args, **kwargs):
        try:
            return function(*args, **kwargs)
        except HugoniotError as error:
            _tell(error)
            raise typer.Exit(error.exit_code) from None
        except KeyboardInterrupt:
            typer.echo("interrupted", err=True)
            raise typer.Exit(130) from None
        except BrokenPipeError:
            _silence_output()
            raise typer.Exit(0) from None
        except (typer.Exit, typer.Abort, SystemExit):
            raise
        except MemoryError:
            typer.echo("error: out of memory; use fewer zones or snapshots (hugoniot check estimates the memory). A run with a "
                       "checkpoint can be resumed", err=True)
            raise typer.Exit(4) from None
        except OSError as error:
            typer.echo(f"error: {_escaped(str(error.filename or 'output'))}: {error.strerror or error}", err=True)
            raise typer.Exit(4) from None
        except Exception as error:
            if type(error).__module__.startswith(("click", "typer")):  # a usage error: typer tells it itself
                raise
            _tell_defect(error)
            raise typer.Exit(1) from None

    return call


def _escaped(text: str) -> str:
    """Lines as they are, without characters that a terminal would obey: names of files may hold any."""
    return "".join(c if c.isprintable() or c == "\n" else f"\\x{ord(c):02x}" for c in text)


def _tell(error: HugoniotError) -> None:
    problems = getattr(error, "problems", None)
    if problems is None:
        typer.echo(f"error: {_escaped(str(error))}", err=True)
        return
    for problem in problems:
        typer.echo(str(problem), err=True)
    if len(problems) > 1:
        typer.echo(error.count, err=True)   # type: ignore[attr-defined]  (a DeckError has it)


def _tell_defect(error: Exception) -> None:
    typer.echo(f"error: unexpected {type(error).__name__}: {str(error)[:300]}\n{_keep_traceback()}", err=True)


def _keep_traceback() -> str:
    """Where the traceback was written: it helps who mends the program, not who runs it."""
    import tempfile

    text = traceback.format_exc()
    try:
        with tempfile.NamedTemporaryFile("w", prefix="hugoniot-error-", suffix=".log", delete=False, encoding="utf-8") as file:
            file.write(text)
        return f"This is a bug in hugoniot; details for a bug report are in {file.name}"
    except OSError:
        return text


def _silence_output() -> None:
    """Whoever read our output is gone: keep the interpreter from complaining about it at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def main(arguments: list[str] | None = None) -> None:
    """Entry point of the command line; `arguments` default to those of the process, which then ends here.

    Raises SystemExit when `arguments` are given.
    """
    if arguments is not None:
        _called(arguments)
        return
    try:
        _called(sys.argv[1:])
        code = 0
    except SystemExit as end:
        code = end.code
    _leave(code if isinstance(code, int) else 0 if code is None else 1)


def _called(arguments: list[str]) -> None:
    # a shell that asks for completions passes the words typed so far, the program's name first
    typed = os.environ.get("COMP_WORDS", os.environ.get("_TYPER_COMPLETE_ARGS", "")).split()[1:] if COMPLETE in os.environ else arguments
    wanted = next((a for a in typed if not a.startswith("-")), None)
    try:
        app = build_app(wanted)
    except Exception as error:  # a command whose module cannot even be imported
        _tell_defect(error)
        sys.exit(1)
    try:
        app(args=arguments, prog_name="hugoniot")
    except KeyboardInterrupt:
        typer.echo("interrupted", err=True)
        sys.exit(130)


def _leave(code: int) -> None:
    """End the process now: the interpreter would take the compiler apart piece by piece, which takes as long as a small run computes.

    Nothing is lost: what a command writes is on the disk when it returns, and its processes and temporary folders end with their contexts.
    """
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except BrokenPipeError:
        pass
    except OSError as error:
        _silence_output()
        os.write(2, f"error: standard output: {error.strerror or error}\n".encode())
        code = code or 4
    os._exit(code)


if __name__ == "__main__":
    main()
