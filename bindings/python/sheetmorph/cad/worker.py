# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program ``sheetmorph-cad``, which alone uses OpenCASCADE, and the pipe to it."""

from __future__ import annotations

import json
import os
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import weakref
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

import numpy as np

from ..base.errors import Fault, KernelError, SheetMorphError
from ..base.kernel import load_kernel
from ..base.progress import Progress

PROGRAM = Path(__file__).resolve().parent.parent / (
    "sheetmorph-cad.exe" if sys.platform == "win32" else "sheetmorph-cad"
)
_NOT_STARTED = 127  # what the loader of programs answers if a library is missing
# A process takes some 30 MB; a model whose worker had to go is read again when it is written.
MOST = 16
_TRY = "try again; if it ends again, repair the shape in the CAD system"


class _Lost(Exception):
    """The other end of the pipe is closed."""


class Worker:
    """A process of the program. It ends with this object, or when this process ends.

    An error of the progress callback or Ctrl+C ends the worker with its request, because nothing
    else stops OpenCASCADE at any moment. Raises KernelError if the program cannot start.
    """

    def __init__(self) -> None:
        if PROGRAM.is_file() and not os.access(PROGRAM, os.X_OK):
            with suppress(OSError):
                PROGRAM.chmod(0o755)  # Python's zipfile loses what may be run
        self._owner = os.getpid()
        self._errors = tempfile.TemporaryFile()
        try:
            self._process = subprocess.Popen(
                [str(PROGRAM)],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._errors,
            )  # fmt: skip
        except OSError as error:
            raise _no_worker(error.strerror or str(error)) from None
        self._busy = threading.Lock()
        self._end = weakref.finalize(self, _end, self._process, self._owner)
        _make_room()
        _LIVING.append(weakref.ref(self))

    @property
    def is_alive(self) -> bool:
        """Whether it accepts requests; a forked process has no worker."""
        return self._owner == os.getpid() and self._end.alive and self._process.poll() is None

    def end_if_idle(self) -> None:
        """End it, unless it works on a request."""
        if self._busy.acquire(blocking=False):
            try:
                self._end()
            finally:
                self._busy.release()

    def request(
        self, doing: str, fields: Sequence[bytes], progress: Progress | None = None
    ) -> tuple[Any, bytes]:
        """Send a request (``core/cad/requests.h``); return the answer and its data.

        doing: the work as a verb in the past, for the message if the worker ends. Raises the errors
        of the kernel: InvalidInput, SolverError, Cancelled; and InvalidInput if the worker ends.
        """
        with self._busy:
            try:
                self._send(fields)
                answer, data = self._answer(progress)
            except _Lost:
                raise self._lost(doing) from None
            except BaseException:
                self._end()
                raise
        if "error" in answer:
            raise _error(answer)
        return answer, data

    def _send(self, fields: Sequence[bytes]) -> None:
        pipe = self._process.stdin
        assert pipe is not None
        try:
            pipe.write(struct.pack("=Q", len(fields)))
            for field in fields:
                pipe.write(struct.pack("=Q", len(field)))
                pipe.write(field)
            pipe.flush()
        except OSError:
            raise _Lost from None

    def _answer(self, progress: Progress | None) -> tuple[Any, bytes]:
        pipe = self._process.stdout
        assert pipe is not None
        while True:
            lengths = struct.unpack("=QQ", _read(pipe, 16))
            text, data = (_read(pipe, length) for length in lengths)
            answer = json.loads(text.decode("utf-8", "replace"), object_hook=_with_array(data))
            if "progress" not in answer:
                return answer, data
            going = None if progress is None else progress(*answer["progress"])
            if not (going is None or going):
                raise load_kernel().Cancelled("cancelled by the user")

    def _lost(self, doing: str) -> Exception:
        """Return an error with the reason why the worker ended."""
        with suppress(subprocess.TimeoutExpired):
            self._process.wait(10)  # it closed the pipe, so it is about to end
        code = self._process.poll()
        self._end()
        self._errors.seek(0)
        lines = self._errors.read().decode("utf-8", "replace").strip().splitlines()
        if code == _NOT_STARTED:
            return _no_worker(lines[-1] if lines else "a library is missing")
        reason = f"exit code {code}"
        if code is not None and code < 0:
            reason = signal.strsignal(-code) or f"signal {-code}"
        what = f"the CAD worker ended unexpectedly while it {doing} ({reason.lower()})"
        return _error({"error": "InvalidInput", "what": what, "brief": what, "todo": _TRY})


_LIVING: list[weakref.ref[Worker]] = []  # the oldest first


def _make_room() -> None:
    """End the oldest idle workers if there are too many."""
    found = [worker for worker in (one() for one in _LIVING) if worker and worker.is_alive]
    for worker in found[: max(0, len(found) + 1 - MOST)]:
        worker.end_if_idle()
    _LIVING[:] = [weakref.ref(worker) for worker in found if worker.is_alive]


def _error(answer: dict[str, str]) -> SheetMorphError:
    """Return the error in an answer, as the kernel raises it."""
    core = load_kernel()
    kind = {"InvalidInput": core.InvalidInput, "SolverError": core.SolverError}[answer["error"]]
    error: SheetMorphError = kind(answer["what"], answer["todo"])
    error.faults = [Fault("", answer["what"], answer["todo"], brief=answer["brief"])]
    return error


def _no_worker(reason: str) -> KernelError:
    what = f"CAD files cannot be read ({PROGRAM.name}: {reason})"
    return KernelError(what, "build and stage it again with ./sheetmorph build")


def _end(process: subprocess.Popen[bytes], owner: int) -> None:
    """End a worker of this process at once."""
    if os.getpid() != owner:
        return
    process.kill()
    process.wait()
    for end in (process.stdin, process.stdout):
        with suppress(OSError):
            if end is not None:
                end.close()


def _read(pipe: IO[bytes], length: int) -> bytes:
    try:
        found = pipe.read(length)
    except OSError:
        raise _Lost from None
    if len(found) < length:
        raise _Lost
    return found


def _with_array(data: bytes) -> Any:
    """Return a hook for JSON that replaces each description of an array by the array."""

    def hook(entry: dict[str, Any]) -> Any:
        if "shape" not in entry:
            return entry
        shape, number = entry["shape"], np.dtype(f"={entry['type']}")
        count = int(np.prod(shape))
        return np.frombuffer(data, number, count, entry["at"]).reshape(shape)

    return hook
