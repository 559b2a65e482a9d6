# SPDX-License-Identifier: LGPL-2.1-or-later
"""The locks of studies, as POSIX has them and as Windows has them (by a stand-in of its module)."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

# Windows locks bytes of an open file, for one process, and knows nothing that is shared.
WINDOWS = """
import fcntl, os, subprocess, sys, types
def locking(file, mode, count):
    assert mode == msvcrt.LK_NBLCK and count > 0
    first = os.lseek(file, 0, os.SEEK_CUR)
    fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB, count, first)
msvcrt = types.ModuleType("msvcrt")
msvcrt.LK_NBLCK, msvcrt.locking = 2, locking
sys.modules.update(msvcrt=msvcrt, fcntl=None)
del os.O_NONBLOCK, os.O_CLOEXEC
"""
SERVE = """
import sys
from contextlib import ExitStack
from pathlib import Path
import sheetmorph.study.leases as leases
from sheetmorph import RecipeError
leases._PATIENCE = 0.0
place, held = Path(sys.argv[1]), ExitStack()
for line in sys.stdin:
    said, kind = "done", line.strip()
    if kind == "let go":
        held.close()
    elif kind == "look":
        said = str(leases.is_abandoned(place / "a.lease", place))
    else:
        try:
            lock = getattr(leases, kind)
            held.enter_context(lock(place / "a.lease" if kind == "Lease" else place))
        except RecipeError:
            said = "busy"
    print(said, flush=True)
"""


class Holder:
    """Another process that takes locks in a folder as it is told."""

    def __init__(self, system: str, place: Path):
        self._process = subprocess.Popen(
            [sys.executable, "-c", system + SERVE, str(place)],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
        )  # fmt: skip

    def does(self, what: str) -> str:
        self._process.stdin.write(what + "\n")
        self._process.stdin.flush()
        return self._process.stdout.readline().strip()

    def kill(self) -> None:
        self._process.kill()
        self._process.communicate()


@pytest.fixture(params=["", WINDOWS], ids=["posix", "windows"])
def holders(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[tuple[Holder, Holder]]:
    """Two processes with the locks of one system."""
    found = Holder(request.param, tmp_path), Holder(request.param, tmp_path)
    yield found
    for holder in found:
        holder.kill()


def test_one_computes_all_runs_or_many_some_of_them(holders: tuple[Holder, Holder]):
    one, other = holders
    assert one.does("alone") == "done"
    assert (other.does("alone"), other.does("among_others")) == ("busy", "busy")
    one.does("let go")
    assert (one.does("among_others"), other.does("among_others")) == ("done", "done")
    assert one.does("let go") == "done" and one.does("alone") == "busy"
    other.does("let go")
    assert one.does("alone") == "done"


def test_a_lease_ends_with_its_process(holders: tuple[Holder, Holder], tmp_path: Path):
    one, other = holders
    assert (one.does("Lease"), other.does("look")) == ("done", "False")
    one.does("let go")
    assert not (tmp_path / "a.lease").exists()
    assert (one.does("Lease"), other.does("look")) == ("done", "False")
    one.kill()
    assert other.does("look") == "True"
