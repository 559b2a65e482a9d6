# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutated files for every reader: each is read, written, moved, or refused in words.

    python3 tests/decks/fuzzing.py READER SECONDS FOLDER

All seconds are the processor's: a busy machine does not shorten the trial. A case that crashes,
hangs for 20 s or takes more than 2 GB is left in FOLDER. Cases that once did are kept in
tests/decks/corpus, one file each, and are replayed by the tests of the package.
"""

from __future__ import annotations

import io
import random
import resource
import signal
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
CORPUS = Path(__file__).parent / "corpus"
LONGEST, MEMORY = 20, 2 << 30

if str(ROOT / "tests" / "package") not in sys.path:
    sys.path.append(str(ROOT / "tests" / "package"))

from deck_samples import deck_samples  # noqa: E402
from joint_samples import joint_samples  # noqa: E402
from sheetmorph import FileError  # noqa: E402
from sheetmorph.decks import read_deck, sheet_of  # noqa: E402
from sheetmorph.joint_files import JointFile, read_joint_bytes  # noqa: E402

# By reader: the endings of its files.
READERS = {
    "nastran": (".bdf",), "ls-dyna": (".k",), "abaqus": (".inp",), "radioss": (".rad",),
    "gmsh": (".msh",), "xmcf": (".xmcf", ".mcf"), "vip": (".vip",), "csv": (".csv",),
}  # fmt: skip
TOKENS = (
    *(b"*", b"$", b",", b"+", b"\t", b"\n", b"\r\n", b"&p", b"1e999", b"-", b"nan", b"9" * 20),
    *(b"*NODE\n", b"GRID    ", b"*INCLUDE\n", b"/NODE\n", b"BEGIN BULK\n", b"$Nodes\n", b"0"),
    *(b"\0", b"\xff", b"*END\n", b"CORD1R,1,1,1,1\n", b"=,*1,=\n", b" " * 9, b"\xef\xbb\xbf"),
    *(b"<loc>", b"</loc>", b"<!--", b"&#0;", b"<![CDATA[", b'"', b"'", b";", b"-1", b"1.5-3"),
    *(b"//SUBMODEL/1\n", b"//ENDSUB\n"),
    *(b"INCLUDE 'x'\n", b"#include x\n", b"*INSTANCE,NAME=A,PART=B\n", b"*SYSTEM\n", b"WSPOT,"),
)


def seeds(reader: str) -> list[tuple[str, bytes]]:
    """(name, bytes) of sound files and of those that once were trouble."""
    endings = READERS[reader]
    found = [*deck_samples().items(), *joint_samples().items()]
    public = ROOT.parent / "shared" / "data" / "09-decks" / reader
    if public.is_dir():
        small = [path for path in sorted(public.iterdir()) if path.stat().st_size < 20000]
        found += [(f"a{endings[0]}", path.read_bytes()) for path in small[:40]]
    found += [(path.name, path.read_bytes()) for path in sorted(CORPUS.glob("*"))]
    return [(name, data) for name, data in found if Path(name).suffix in endings]


def mutated(data: bytes, dice: random.Random) -> bytes:
    """The data with bytes taken out, put in, turned over, doubled or cut off."""
    for _ in range(dice.choice((1, 1, 2, 3, 6))):
        at, length = dice.randrange(len(data) + 1), dice.choice((0, 1, 2, 8, 40))
        kind = dice.randrange(8)
        if kind < 4:
            data = data[:at] + dice.choice(TOKENS) + data[at + length :]
        elif kind == 4 and at < len(data):
            data = data[:at] + bytes([data[at] ^ (1 << dice.randrange(8))]) + data[at + 1 :]
        elif kind == 5:
            lines = data.split(b"\n")
            one, other = dice.randrange(len(lines)), dice.randrange(len(lines))
            lines.insert(one, lines[other])
            data = b"\n".join(lines)
        elif kind == 6:
            lines = data.split(b"\n")
            del lines[dice.randrange(len(lines))]
            data = b"\n".join(lines)
        elif dice.randrange(8) == 0:
            data = data[:at]
    return data


def check_case(name: str, data: bytes) -> None:
    """Read, write, move and read again; what is wrong must be a FileError."""
    try:
        if Path(name).suffix in (".bdf", ".k", ".inp", ".rad", ".msh"):
            _try_deck(name, data)
        else:
            _try_joints(read_joint_bytes(Path(name), data))
    except FileError as error:
        assert error.what and error.todo and "Traceback" not in str(error)


def _try_deck(name: str, data: bytes) -> None:
    deck = read_deck(Path("nowhere") / name, lambda path: data)
    assert _written(deck, deck.points) == data
    free = ~np.isin(deck.ids, sorted(deck.raw.locked))
    again = read_deck(
        Path("nowhere") / name,
        lambda path: _written(deck, deck.points + np.where(free[:, None], 0.25, 0.0)),
    )
    assert np.array_equal(again.ids, deck.ids)
    sheet_of(deck)


def _written(deck, positions: np.ndarray) -> bytes:
    out = io.BytesIO()
    deck.save(positions, 0, out)
    return out.getvalue()


def _try_joints(file: JointFile) -> None:
    out = io.BytesIO()
    file.save(file.points, file.directions, out)
    assert out.getvalue() == file.data
    out = io.BytesIO()
    file.save(file.points + 0.25, file.directions, out)
    again = read_joint_bytes(file.path, out.getvalue())
    assert len(again.joints) == len(file.joints) and len(again.points) == len(file.points)


def fuzz(reader: str, seconds: float, folder: Path) -> tuple[int, list[Path]]:
    """How many cases there were, and those that failed, as files."""
    given, dice = seeds(reader), random.Random(f"{reader}{time.time_ns()}")
    end, count, failed = time.process_time() + seconds, 0, []
    while time.process_time() < end and len(failed) < 20:
        name, data = dice.choice(given)
        case = mutated(data, dice)
        count += 1
        why = guarded(lambda: check_case(name, case))
        if why:
            path = folder / f"{reader}-{len(failed)}{Path(name).suffix}"
            path.write_bytes(case)
            path.with_suffix(".txt").write_text(why + "\n")
            failed.append(path)
    return count, failed


def guarded(work: Callable[[], None]) -> str:
    """What went wrong; empty if nothing did."""

    def late(_number, _frame):
        raise TimeoutError(f"longer than {LONGEST} s")

    signal.signal(signal.SIGPROF, late)
    signal.setitimer(signal.ITIMER_PROF, LONGEST)
    try:
        work()
    except BaseException as error:  # whatever it is
        if isinstance(error, KeyboardInterrupt):
            raise
        return f"{type(error).__name__}: {error}"
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    return ""


def main(reader: str, seconds: str, folder: str) -> int:
    """Fuzz one reader; 1 if a case failed."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    count, failed = fuzz(reader, float(seconds), Path(folder))
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
    print(f"{reader}: {count} files in {seconds} s, {len(failed)} failed, {peak} MB at most")
    for path in failed:
        print(f"{path}: {path.with_suffix('.txt').read_text().strip()[:300]}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
