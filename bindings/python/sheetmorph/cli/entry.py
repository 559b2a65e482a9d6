# SPDX-License-Identifier: LGPL-2.1-or-later
"""The entry of the command line: it runs a command and turns every error into a sentence."""

from __future__ import annotations

import argparse
import contextlib
import importlib
import signal
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from types import FrameType

from ..base.errors import FailedError, KernelError, SheetMorphError
from ..decks.dyna import assumed_options
from ..files.atomic import FileSet
from ..files.signals import stopping_signals
from .arguments import parser
from .output import BAD_INPUT, NOT_CERTIFIED, Outcome
from .output import as_json, complain, require_target, say, write_target
from .parsing import STDOUT

_INTERRUPTED = 130
# They write the file of `--json` together with their other files, or nothing.
_OWN_TARGET = ("run", "check", "certify")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command and return its exit status.

    The status is 0 if done, 2 for bad input, 3 for a failed certificate or run, and 130 if
    interrupted.
    """
    wanted = parser().parse_args(arguments)
    if wanted.report == STDOUT:
        wanted.json, wanted.report = STDOUT, None if wanted.json == STDOUT else wanted.json
    files = FileSet(wanted.command, force=getattr(wanted, "force", False))
    previous = {}
    try:
        for number in stopping_signals():
            if signal.getsignal(number) is not signal.SIG_IGN:  # as nohup wants
                previous[number] = signal.signal(number, _interrupt)
        with _deck_options(wanted):
            if wanted.command not in _OWN_TARGET:
                require_target(wanted, _inputs_of(wanted), files)
            outcome = _command(wanted.command)(wanted, files)
            if wanted.command not in _OWN_TARGET:
                write_target(wanted, outcome.data, files.reads)
            say(as_json(outcome.data) if wanted.json == STDOUT else outcome.lines)
        return outcome.status
    except KeyboardInterrupt as stopped:
        complain(f"interrupted: {str(stopped) or _state(files)}")
        return _INTERRUPTED
    except Exception as error:  # This is the edge of the program: every error becomes a sentence.
        found, status = _explained(error, _inputs_of(wanted)[0], files)
        if wanted.json == STDOUT:
            _say_json(wanted.command, found, error)
        complain(str(found))
        return status
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)


def _command(name: str) -> Callable[[argparse.Namespace, FileSet], Outcome]:
    """Return the function of a command. Its module loads only now: --help answers at once."""
    module = importlib.import_module(f"{__package__}.{name}")
    found: Callable[[argparse.Namespace, FileSet], Outcome] = module.execute
    return found


def _deck_options(wanted: argparse.Namespace) -> contextlib.AbstractContextManager[None]:
    """Return the context that applies the `--keyword` option to decks."""
    if not getattr(wanted, "keyword", None):
        return contextlib.nullcontext()
    return assumed_options(wanted.keyword)


def _inputs_of(wanted: argparse.Namespace) -> list[str]:
    """Return the files that a command names as its input, or the command if there is none."""
    one = getattr(wanted, "recipe", getattr(wanted, "file", wanted.command))
    return getattr(wanted, "files", None) or [one]


def _interrupt(_number: int, _frame: FrameType | None) -> None:
    raise KeyboardInterrupt


def _state(files: FileSet) -> str:
    return "all files were written" if files.committed else "no part was written"


def _say_json(command: str, found: SheetMorphError, error: Exception) -> None:
    """Print the faults, unless a certificate or the report of a run says them."""
    certificate = getattr(error, "certificate", None)
    if certificate is None:
        say(as_json({"valid": False, "faults": [fault.to_json() for fault in found.faults]}))
    elif command == "certify":
        say(as_json(certificate))


def _explained(error: Exception, recipe: str, files: FileSet) -> tuple[SheetMorphError, int]:
    """Return the faults of an error with the text to print, and the exit status."""
    if isinstance(error, SheetMorphError):
        is_input = isinstance(error, (ValueError, KernelError))
        if is_input:
            return error, BAD_INPUT
        # An earlier run wrote the files of a certificate, so nothing is said about writing.
        state = "" if hasattr(error, "certificate") else f"; {_state(files)}"
        return SheetMorphError(error.faults, f"{recipe}: {error}{state}"), NOT_CERTIFIED
    if isinstance(error, OSError):
        what, todo = str(error.strerror or error), "check the path and its rights"
        return FailedError(what, todo, error.filename or recipe), BAD_INPUT
    if isinstance(error, MemoryError):
        return FailedError("not enough memory", _state(files), recipe), NOT_CERTIFIED
    last = traceback.extract_tb(error.__traceback__)[-1]
    said = " ".join(f"{type(error).__name__}: {error}".split())
    what = f"SheetMorph has a bug ({said}, {Path(last.filename).name}, line {last.lineno})"
    todo = f"{_state(files)}; please report it with this recipe"
    return FailedError(what, todo, recipe), NOT_CERTIFIED
