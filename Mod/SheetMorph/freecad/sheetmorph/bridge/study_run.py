# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study in a separate process, with the package that this workbench uses."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from freecad.sheetmorph.bridge import kernel

OUT, SUMMARY = "out", "summary.json"
# The process runs the command line, and a thread that waits for the end of FreeCAD. The thread uses
# os.read, because forked processes would inherit the lock of a file object. A FreeCAD started in
# the background of a shell ignores interrupts, and its children inherit this; `cancel` needs them.
BOUND = """
import os, runpy, signal, threading

def end_with_freecad():
    os.read(0, 1)
    os.killpg(0, signal.SIGKILL)

signal.signal(signal.SIGINT, signal.default_int_handler)
threading.Thread(target=end_with_freecad, daemon=True).start()
runpy.run_module("sheetmorph", run_name="__main__", alter_sys=True)
"""


class StudyRun:
    """A running study; `end` leaves no process and no temporary file."""

    def __init__(self, study_file: Path):
        """Start the study. Raises OSError if there is no Python interpreter."""
        if not os.path.isfile(interpreter()):
            raise OSError(
                f"There is no Python at {interpreter()} to compute the study with; write it with "
                "api.write_study and compute it on the command line."
            )
        self._out = study_file.parent / OUT
        self._said = tempfile.TemporaryFile()
        package = str(kernel.package_folder().parent)
        paths = [package, *filter(None, [os.environ.get("PYTHONPATH")])]
        words = [interpreter(), "-c", BOUND, "study", str(study_file), "-o", str(self._out)]
        # In a separate process group, so that its children end with it.
        self._process = subprocess.Popen(
            [*words, "--engine", "processes", "--quiet"],
            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=self._said,
            start_new_session=True,
        )

    @property
    def is_over(self) -> bool:
        """Whether the process has ended or was cancelled."""
        return self._process.poll() is not None

    @property
    def done(self) -> int:
        """Number of finished variants."""
        if not self._out.is_dir():
            return 0
        return sum(name.isdecimal() for name in os.listdir(self._out))

    @property
    def fault(self) -> str:
        """Return the reason for a missing table in one sentence; empty if there is a table."""
        if (self._out / SUMMARY).is_file():
            return ""
        self._said.seek(0)
        lines = self._said.read().decode("utf-8", "replace").strip().splitlines()
        return lines[-1] if lines else "The study was cancelled before its first variant."

    def results(self) -> dict:
        """Return the table of a finished run.

        Raises ValueError with the reason if there is none.
        """
        if self.fault:
            raise ValueError(self.fault)
        return json.loads((self._out / SUMMARY).read_text("utf-8"))

    def cancel(self) -> None:
        """Make the process write a table of the finished variants, and end."""
        if not self.is_over:
            self._process.send_signal(signal.SIGINT)

    def end(self) -> None:
        """Kill the process with its children; a second call does nothing."""
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        self._process.stdin.close()
        self._said.close()


def interpreter() -> str:
    """Return the path of FreeCAD's Python, because `sys.executable` may be FreeCAD."""
    return os.path.join(sys.base_prefix, "bin", "python{}.{}".format(*sys.version_info))
