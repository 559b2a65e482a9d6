# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: python3 -m sheetmorph init | show | check | run | resolve | find | ..."""

from __future__ import annotations

import argparse
import contextlib
import math
import signal
import sys
import traceback
from collections.abc import Sequence
from pathlib import Path
from types import FrameType
from typing import Any, TextIO

from . import __version__
from .cli_certify import add_certify_arguments, certified_run, judged_run, require_criteria
from .cli_certify import run_certify
from .cli_copy import run_copy
from .cli_find import add_find_arguments, run_find
from .cli_flatten import add_flatten_arguments, run_flatten
from .cli_progress import progress_on
from .cli_recipes import RECIPE_COMMANDS, add_recipe_commands, add_unit_argument
from .cli_resolve import add_resolve_arguments, run_resolve
from .cli_table import ending_of
from .cli_study import add_study_arguments, run_study_command
from .cli_values import STDOUT, Parser, add_json_argument, as_json, json_file
from .errors import Fault, FileError, KernelError, RecipeError
from .files.atomic import FileSet
from .files.signals import stopping_signals

DONE, BAD_INPUT, NOT_CERTIFIED = 0, 2, 3
_INTERRUPTED = 130
_POSE_HELP = (
    "name of one of the recipe's poses, or a JSON file with a pose (default: the recipe's pose)"
)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command and return its exit status.

    The status is 0 if done, 2 for bad input, 3 for a failed certificate or run, and 130 if
    interrupted.
    """
    wanted = parser().parse_args(arguments)
    files = FileSet(wanted.command, force=getattr(wanted, "force", False))
    numbers = [number for number in stopping_signals() if number != signal.SIGINT]
    previous = {number: signal.signal(number, _interrupt) for number in numbers}
    try:
        with _deck_options(wanted):
            _say(_COMMANDS[wanted.command](wanted, files))
        return DONE
    except KeyboardInterrupt as stopped:
        _complain(f"interrupted: {str(stopped) or _state(files)}")
        return _INTERRUPTED
    except Exception as error:  # This is the edge of the program: every error becomes a sentence.
        text, status = _explain(error, _input_of(wanted), files)
        if wanted.command == "certify" and wanted.json == STDOUT and hasattr(error, "certificate"):
            _say(as_json(error.certificate))
        _complain(text)
        return status
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)


def _deck_options(wanted: argparse.Namespace) -> contextlib.AbstractContextManager[None]:
    """Return the context that applies the `--keyword` option to decks."""
    if not getattr(wanted, "keyword", None):
        return contextlib.nullcontext()
    from .decks.dyna import assumed_options

    return assumed_options(wanted.keyword)


def _input_of(wanted: argparse.Namespace) -> str:
    files = getattr(wanted, "files", None)
    found: str = (
        files[0] if files else getattr(wanted, "recipe", getattr(wanted, "file", wanted.command))
    )
    return found


def _interrupt(_number: int, _frame: FrameType | None) -> None:
    raise KeyboardInterrupt


def _state(files: FileSet) -> str:
    return "all files were written" if files.committed else "no part was written"


def _explain(error: Exception, recipe: str, files: FileSet) -> tuple[str, int]:
    """Return the message for an error and the exit status."""
    if isinstance(error, (RecipeError, FileError, KernelError)):
        return str(error), BAD_INPUT
    if isinstance(error, OSError):
        place = error.filename or recipe
        return f"{place}: {error.strerror or error}; check the path and its rights", BAD_INPUT
    if isinstance(error, MemoryError):
        return f"{recipe}: not enough memory; {_state(files)}", NOT_CERTIFIED
    # An earlier run wrote the files, so the message says nothing about writing.
    if getattr(error, "certificate", None) is not None:
        return f"{recipe}: {error}", NOT_CERTIFIED
    # The kernel's SolverError, or a certificate that failed.
    if isinstance(error, RuntimeError) and type(error).__module__.startswith("sheetmorph"):
        return f"{recipe}: {error}; {_state(files)}", NOT_CERTIFIED
    last = traceback.extract_tb(error.__traceback__)[-1]
    what = " ".join(f"{type(error).__name__}: {error}".split())
    place = f"{Path(last.filename).name}, line {last.lineno}"
    text = f"{recipe}: SheetMorph has a bug ({what}, {place}); {_state(files)}; please report"
    return f"{text} it with this recipe", NOT_CERTIFIED


def _say(lines: list[str]) -> None:
    """Print to stdout; a closed or full stdout does not turn a success into a failure."""
    try:
        for line in lines:
            print(_printable(line, sys.stdout))
        if sys.stdout is not None:
            sys.stdout.flush()
    except (OSError, ValueError) as error:
        # What is left in the buffer would fail again at exit.
        sys.stdout = None  # type: ignore[assignment]  # as Python itself has it without a console
        if not isinstance(error, BrokenPipeError):
            _complain(f"done, but stdout cannot be written ({error})")


def _complain(text: str) -> None:
    with contextlib.suppress(OSError, ValueError):
        print(_printable(text, sys.stderr), file=sys.stderr)


def _printable(text: str, stream: TextIO | None) -> str:
    encoding = getattr(stream, "encoding", None) or "utf-8"
    return text.encode(encoding, "backslashreplace").decode(encoding)


def parser() -> argparse.ArgumentParser:
    """Return the argument parser, from which manual page and shell completion are generated."""
    started = Path(sys.argv[0]).name
    parser = Parser(
        prog="python3 -m sheetmorph" if started == "__main__.py" else started,
        description="Deform sheet-metal parts by a recipe; form features stay rigid.",
        epilog="Exit status: 0 done; 2 bad input, nothing written; 3 a certificate fails; "
        "130 interrupted.",
    )
    parser.add_argument("--version", action="version", version=f"sheetmorph {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    run = commands.add_parser("run", help="deform the parts of a recipe and write them")
    check = commands.add_parser("check", help="do all that run does, but write nothing")
    add_resolve_arguments(commands)
    for command in (run, check):
        command.add_argument("recipe", help="JSON or TOML file; the part files are relative to it")
        text = "folder for the parts"
        command.add_argument("-o", "--output", required=command is run, metavar="DIR", help=text)
        command.add_argument("--pose", metavar="POSE", help=_POSE_HELP)
        text = "also write the parts of CAD files as STEP"
        command.add_argument("--step", action="store_true", help=text)
        command.add_argument("--report", metavar="FILE", help="where to write the report (JSON)")
        text = "write before.png and after.png next to the parts"
        command.add_argument("--pictures", action="store_true", help=text)
        text = "exit with status 3 on warnings, such as open contacts"
        command.add_argument("--strict", action="store_true", help=text)
        command.add_argument("--quiet", action="store_true", help="do not print progress to stderr")
    _add_doctor(commands)
    add_find_arguments(commands)
    add_flatten_arguments(commands)
    add_certify_arguments(commands, (run, check))
    add_recipe_commands(commands)
    add_study_arguments(commands)
    add_json_argument([commands.choices[name] for name in ("run", "check", "certify")])
    _add_force(commands)
    return parser


def _add_doctor(commands: Any) -> None:
    doctor = commands.add_parser("doctor", help="describe meshes and their faults")
    doctor.add_argument("files", nargs="+", metavar="FILE", help="mesh file")
    text = "merge distance of vertices, mm (default: a millionth of the size)"
    doctor.add_argument("--tolerance", type=_length, metavar="MM", help=text)
    add_unit_argument(doctor)


def _add_force(commands: Any) -> None:
    text = "also overwrite files that SheetMorph did not write"
    for name in ("run", "check", "resolve", "find", "flatten", "copy", "certify", "show", "study"):
        commands.choices[name].add_argument("--force", action="store_true", help=text)


def _length(text: str) -> float:
    value = float(text)
    if not 0.0 <= value < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is not a length; give a number of 0 or more")
    return value


def _run(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    # Imported here, so that --help answers at once.
    from .certifying import NotCertified
    from .running import run

    require_criteria(wanted)
    with progress_on(sys.stderr, wanted.quiet) as progress:
        report = run(
            wanted.recipe, wanted.output, wanted.pose, _report_of(wanted),
            files=files, strict=wanted.strict, pictures=wanted.pictures, step=wanted.step,
            wide=wanted.wide, repair=wanted.repair, progress=progress,
        )  # fmt: skip
    lines = ending_of(report, wanted.output, is_quiet=wanted.quiet)
    try:
        certified = certified_run(wanted) if wanted.certify else []
    except NotCertified:
        seen = f"{wanted.output}: certificate.html shows what fails"
        _say(as_json(report) if wanted.json == STDOUT else [*lines, seen])
        raise
    return as_json(report) if wanted.json == STDOUT else [*lines, *certified]


def _report_of(wanted: argparse.Namespace) -> Path | str | None:
    """Return the file for the report, that of `--json` or of its older name `--report`."""
    named: str | None = wanted.report
    file = json_file(wanted)
    if named is not None and file is not None:
        what = f"--report names {named} already"
        raise RecipeError([Fault("--json", what, "leave out one of the two files")])
    return named if file is None else file


def _check(wanted: argparse.Namespace, _files: FileSet) -> list[str]:
    from .running import NOT_TRIED, check

    require_criteria(wanted)
    judge = (lambda folder: judged_run(wanted, folder)) if wanted.certify else None
    with progress_on(sys.stderr, wanted.quiet) as progress:
        told = check(
            wanted.recipe, out_dir=wanted.output, pose=wanted.pose, report=_report_of(wanted),
            strict=wanted.strict, pictures=wanted.pictures, step=wanted.step, wide=wanted.wide,
            repair=wanted.repair, judge=judge, progress=progress, force=wanted.force,
        )  # fmt: skip
    untried = [text for text in told if getattr(text, "code", "") == NOT_TRIED]
    warnings = [text for text in told if text not in untried]
    if wanted.json == STDOUT:
        return as_json({"valid": True, "warnings": warnings, "notes": untried})
    verdict = "; ".join([f"{wanted.recipe}: valid", *untried])
    return [*(f"warning: {text}" for text in warnings), verdict]


def _doctor(wanted: argparse.Namespace, _files: FileSet) -> list[str]:
    from .doctor import diagnose_files

    found = diagnose_files(wanted.files, wanted.tolerance, wanted.unit)
    return as_json(found)


def _find(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    return run_find(wanted, files)


_COMMANDS = {
    "certify": run_certify,
    "copy": run_copy,
    "run": _run,
    "check": _check,
    "resolve": run_resolve,
    "doctor": _doctor,
    "find": _find,
    "flatten": run_flatten,
    "study": run_study_command,
    **RECIPE_COMMANDS,
}
