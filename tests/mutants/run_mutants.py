# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plants mistakes in the kernel, one at a time, and counts those that its tests notice.

    run_mutants.py BUILD [WORD...]

The output ends with the score of every folder of the kernel, the survivors and the whole score.
BUILD is a build folder in which the C++ tests are built. WORDs restrict the run to mutations whose
label contains one of them. The source and the build folder stay as they are: each mistake is
compiled from a copy of its file, and the object is linked into a copy of the test program in
front of the libraries. A verdict is kept below BUILD/mutants until the test program changes, so an
interrupted run continues. The exit status is 0 if at least 95 % of the mistakes are noticed.
"""
from __future__ import annotations

import argparse
import hashlib
import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parent))
from mutation import KERNEL, Mutation  # noqa: E402
from mutations import MUTATIONS  # noqa: E402

LEAST_SHARE = 0.95  # of the mistakes that the tests must notice
SLOWER = 10.0  # A mistake may slow the tests down by this factor before they count as hanging,
PATIENCE = 60.0  # and by so many seconds.
FAILED = re.compile(r"^\[  FAILED  \] (\S+?)(?:,| \()", re.MULTILINE)
RAN = re.compile(r"^\[==========\] (\d+) tests? from .* ran", re.MULTILINE)


class Ended(NamedTuple):
    """How a command ended; status None means that it ran too long."""

    status: int | None
    said: str
    seconds: float


class Verdict(NamedTuple):
    """What became of a mutation."""

    kind: str  # killed, survived, or unsound: nothing was tested
    reason: str
    seconds: float = 0.0


def call(command: list[str], folder: Path, limit: float | None = None) -> Ended:
    """Run a command; kill it and all that it started after `limit` seconds."""
    start = time.monotonic()
    process = subprocess.Popen(
        command,
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )
    status: int | None = None
    try:
        said = process.communicate(timeout=limit)[0]
        status = process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        said = process.communicate()[0]
    return Ended(status, said.decode(errors="replace"), time.monotonic() - start)


def with_output(command: list[str], output: Path) -> list[str]:
    """A compiler's command that writes to another file."""
    place = command.index("-o") + 1
    return [*command[:place], str(output), *command[place + 1 :]]


class Laboratory:
    """Compiles, links and tests mutations of one build."""

    def __init__(self, build: Path):
        self.build = build
        self.folder = build / "mutants"
        self.folder.mkdir(exist_ok=True)
        entries = json.loads((build / "compile_commands.json").read_text("utf-8"))
        self._compile = {Path(entry["file"]): shlex.split(entry["command"]) for entry in entries}
        self._links: dict[str, list[str]] = {}
        self._digests: dict[str, bytes] = {}
        self._seconds: dict[tuple[str, str], float] = {}
        self._locks: dict[tuple[str, str], threading.Lock] = {}
        self._guard = threading.Lock()

    def prepare(self, programs: set[str]) -> None:
        """Read how the test programs are linked, and what they are."""
        for program in sorted(programs):
            asked = ["ninja", "-C", str(self.build), "-t", "commands", program]
            lines = subprocess.run(asked, check=True, capture_output=True, text=True).stdout
            (self._links[program],) = (
                shlex.split(part)
                for part in lines.splitlines()[-1].split("&&")
                if f" -o tests/{program} " in part
            )
            original = self._original(program)
            if original.is_file():
                self._digests[program] = hashlib.sha256(original.read_bytes()).digest()

    def judge(self, number: int, mutation: Mutation) -> Verdict:
        """Plant one mistake and run its tests, unless that was done before."""
        try:
            text = mutation.applied()
        except ValueError as error:
            return Verdict("unsound", str(error))
        if mutation.program not in self._digests:
            return Verdict("unsound", f"{mutation.program} is not built")
        digest = hashlib.sha256(self._digests[mutation.program])
        for part in (text, mutation.tests):
            digest.update(part.encode() + b"\0")
        known = self.folder / f"{digest.hexdigest()}.json"
        if known.is_file():
            return Verdict(*json.loads(known.read_text("utf-8")))
        scratch = self.folder / f"{number:03d}"
        shutil.rmtree(scratch, ignore_errors=True)
        scratch.mkdir()
        try:
            verdict = self._tested(mutation, text, scratch)
        finally:
            shutil.rmtree(scratch)
        if verdict.kind != "unsound":
            known.write_text(json.dumps(verdict), "utf-8")
        return verdict

    def _original(self, program: str) -> Path:
        return self.build / "tests" / program

    def _run(self, program: Path, tests: str, limit: float | None = None) -> Ended:
        return call(
            [str(program), f"--gtest_filter={tests}", "--gtest_fail_fast"], self.build, limit
        )

    def _limit(self, mutation: Mutation) -> float | None:
        """Seconds that the tests may take; None if they fail without any mistake."""
        key = (mutation.program, mutation.tests)
        with self._guard:
            lock = self._locks.setdefault(key, threading.Lock())
        with lock:
            if key not in self._seconds:
                ended = self._run(self._original(mutation.program), mutation.tests)
                ran = RAN.search(ended.said)
                is_sound = ended.status == 0 and ran is not None and int(ran[1]) > 0
                self._seconds[key] = ended.seconds if is_sound else -1.0
        seconds = self._seconds[key]
        return None if seconds < 0.0 else SLOWER * seconds + PATIENCE

    def _tested(self, mutation: Mutation, text: str, scratch: Path) -> Verdict:
        start = time.monotonic()
        original = KERNEL / mutation.file
        # Kernels include themselves by this path, once for each instruction set.
        source, mutated = scratch / "sheetmorph" / mutation.file, scratch / "mutated.o"
        source.parent.mkdir(parents=True)
        source.write_text(text, "utf-8")
        limit = self._limit(mutation)
        if limit is None:
            return Verdict("unsound", f"{mutation.tests}: fails or finds no test without a mistake")
        changed = {str(original): str(source), "-O3": "-O1"}  # compiles in half the time
        command = [changed.get(part, part) for part in self._compile[original]]
        ccache = shutil.which("ccache")
        command = ([ccache] if ccache else []) + with_output(command, mutated)
        command += ["-iquote", str(scratch)]
        compiled = call(command, self.build)
        if compiled.status != 0:
            return Verdict("unsound", "does not compile: " + compiled.said[-2000:])
        program = scratch / "tests"
        link = with_output(self._links[mutation.program], program)
        place = link.index(str(program)) + 1
        linked = call([*link[:place], str(mutated), *link[place:]], self.build)
        if linked.status != 0:
            return Verdict("unsound", "does not link: " + linked.said[-2000:])
        ended = self._run(program, mutation.tests, limit)
        return verdict_of(ended, time.monotonic() - start)


def verdict_of(ended: Ended, seconds: float) -> Verdict:
    """Whether tests that ended in this way noticed a mistake."""
    if ended.status == 0:
        return Verdict("survived", "all tests passed", seconds)
    if ended.status is None:
        return Verdict("killed", "the tests never ended", seconds)
    failed = FAILED.search(ended.said)
    return Verdict("killed", failed[1] if failed else f"ended with {ended.status}", seconds)


def score(judged: list[tuple[Mutation, Verdict]]) -> int:
    """Print the score of every folder, the survivors and the score of the whole.

    Returns 0 if enough mistakes were noticed and all of them were tested.
    """
    kinds = [verdict.kind for _, verdict in judged]
    killed, unsound = kinds.count("killed"), kinds.count("unsound")
    for folder in sorted({mutation.folder for mutation, _ in judged}):
        own = [verdict.kind for mutation, verdict in judged if mutation.folder == folder]
        print(f"{own.count('killed'):4} of {len(own):3} killed in {folder}")
    for mutation, verdict in judged:
        if verdict.kind != "killed":
            print(f"{verdict.kind}: {mutation.label}")
    print(f"mutants: {killed} of {len(kinds)} killed, {unsound} could not be tested")
    return 0 if kinds and unsound == 0 and killed >= LEAST_SHARE * len(kinds) else 1


def main(arguments: list[str]) -> int:
    """Judge all mutations side by side and print a table."""
    parser = argparse.ArgumentParser(description="Plants mistakes in the kernel.")
    parser.add_argument("build", type=Path)
    parser.add_argument("words", nargs="*", metavar="WORD")
    options = parser.parse_args(arguments)
    chosen = [
        (number, mutation)
        for number, mutation in enumerate(MUTATIONS)
        if not options.words or any(word in mutation.label for word in options.words)
    ]
    laboratory = Laboratory(options.build.resolve())
    laboratory.prepare({mutation.program for _, mutation in chosen})
    judged = []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        verdicts = pool.map(lambda one: laboratory.judge(*one), chosen)
        for (_, mutation), verdict in zip(chosen, verdicts):
            judged.append((mutation, verdict))
            told = f"{verdict.kind:8} {verdict.seconds:5.0f} s  {mutation.label}"
            mark = "" if verdict.kind == "killed" else "NOTE "
            print(f"{mark}{told}  [{verdict.reason}]", flush=True)
    return score(judged)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
