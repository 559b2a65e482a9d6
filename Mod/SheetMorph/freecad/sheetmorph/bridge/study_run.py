# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study that is computed in a process of its own, of the package that this workbench uses."""

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
# What the process runs: the command line, and beside it one who waits for the end of FreeCAD,
# however that comes. Not by a file object: its lock would be held in what is forked. A FreeCAD that
# a shell started in the background ignores interrupts, and hands that down; `cancel` needs them.
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
    """From its beginning to `end`, which leaves no process and no temporary file."""

    def __init__(self, study_file: Path):
        """Begin; raises OSError where there is no Python to run it."""
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
        # A group of its own: what it starts ends with it.
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
        """Whether it has ended by itself, or been cancelled."""
        return self._process.poll() is not None

    @property
    def done(self) -> int:
        """How many variants are there."""
        if not self._out.is_dir():
            return 0
        return sum(name.isdecimal() for name in os.listdir(self._out))

    @property
    def fault(self) -> str:
        """Why there is no table, one sentence; empty if there is one."""
        if (self._out / SUMMARY).is_file():
            return ""
        self._said.seek(0)
        lines = self._said.read().decode("utf-8", "replace").strip().splitlines()
        return lines[-1] if lines else "The study was cancelled before its first variant."

    def results(self) -> dict:
        """Return the table, after it is over; raises ValueError with why there is none."""
        if self.fault:
            raise ValueError(self.fault)
        return json.loads((self._out / SUMMARY).read_text("utf-8"))

    def cancel(self) -> None:
        """Let it write a table of what is done, and end."""
        if not self.is_over:
            self._process.send_signal(signal.SIGINT)

    def end(self) -> None:
        """End it at once, with all that it has started; a second call does nothing."""
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        self._process.stdin.close()
        self._said.close()


def interpreter() -> str:
    """Return the path of the Python that this FreeCAD embeds: `sys.executable` may be FreeCAD."""
    return os.path.join(sys.base_prefix, "bin", "python{}.{}".format(*sys.version_info))
