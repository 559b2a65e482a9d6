# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the test suites and closes with one line of counts.

The GUI tests, which mostly wait, run beside the others; those run one after another. Called by
`./sheetmorph test`, after the build. A suite that is missing, empty, killed or silent counts as a
failure.
"""
import argparse
import os
import re
import subprocess
import sys
import threading
import time
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PYTHON = sys.executable  # the one FreeCAD embeds, which ./sheetmorph found
PYTEST_FOLDERS = ("tests/architecture", "tests/bindings", "tests/package")
LINES_OF_A_FAILURE = 400
# How the runners name a test that failed: ctest, pytest, unittest, the GUI tests.
FAILURE = re.compile(r"^\s*\d+ - .*\((Failed|SEGFAULT|Timeout)|^(FAILED|ERROR|FAIL)[ :]")
SECOND_TRY = re.compile(r"^SECOND TRY (\S+)")
# Of Debian 12: others break lines otherwise, or know other types of numpy.
CHECKED_BY = {"clang-format": "14", "black": "23", "mypy": "1.0"}
LONGEST_SUITE = 3600  # seconds, then it hangs
FUZZED = "SHEETMORPH_FUZZ_SECONDS"
SLOW = "SHEETMORPH_SLOW_SUITE"  # set for a suite that may take LONGEST_OF_ALL
LONGEST_OF_ALL = 4 * 3600  # of those that take an hour of the processor
# What of the package's tests goes through the whole kernel: its files, CAD, picking, live frames.
# Each in an interpreter of its own: both folders have helpers of one name.
SANITIZED_PYTEST = {
    "sanitize-bindings": ["tests/bindings"],
    "sanitize-package": [
        f"tests/package/test_{name}.py"
        for name in ("cad_features", "cad_files", "features", "finding", "live_frames")
        + ("malformed_files", "mesh_details", "picking_tools", "solids", "thin_solids")
    ],
}
# The first report ends the program with a failure, whatever the test would have said.
ADDRESS_SANITIZER = {
    "ASAN_OPTIONS": "detect_leaks=1:detect_stack_use_after_return=1:check_initialization_order=1",
    "UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1",
    "LSAN_OPTIONS": f"print_suppressions=0:suppressions={ROOT}/tests/core/leaks_of_others.txt",
}
# libgomp and OpenBLAS are not instrumented, their barriers are invisible: one thread each, and what
# they and CHOLMOD, the oracle of the tests, write among themselves does not count. The threads of
# the kernel itself are what is watched.
THREAD_SANITIZER = {
    "TSAN_OPTIONS": "halt_on_error=1:second_deadlock_stack=1:ignore_noninstrumented_modules=1",
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
}


@dataclass
class Count:
    """How many tests of a suite passed, failed and were skipped."""

    passed: int = 0
    failed: int = 0
    skipped: int = 0
    second: int = 0  # of those that passed: only at the second try

    def __add__(self, other: "Count") -> "Count":
        return Count(
            self.passed + other.passed,
            self.failed + other.failed,
            self.skipped + other.skipped,
            self.second + other.second,
        )


class Suites:
    """The suites of a built tree; each method runs one and returns its counts."""

    def __init__(self, build: Path):
        self.build = build
        self.staged = build / "Mod" / "SheetMorph"
        self.results = build / "test"
        self.results.mkdir(parents=True, exist_ok=True)
        for log in self.results.glob("*.log"):
            log.unlink()
        self.failures: list[str] = []
        self.second_tries: list[str] = []
        self._telling = threading.Lock()
        self._calls = 0
        self._running: list[subprocess.Popen] = []

    def core(self) -> Count:
        """The C++ tests, through ctest."""
        return self._ctest(self.build, "core")

    def python(self) -> Count:
        """Architecture, bindings and package, through pytest."""
        total = Count()
        for folder in PYTEST_FOLDERS:
            total += self._pytest(folder.replace("/", "-"), [folder], self.staged)
        return total

    def sanitize(self) -> Count:
        """C++ tests and Python tests of the kernel in builds that watch memory and threads."""
        address = self.build / "sanitize" / "address"
        total = self._ctest(address, "sanitize-core", **ADDRESS_SANITIZER)
        for name, paths in SANITIZED_PYTEST.items():
            staged = address / "Mod" / "SheetMorph"
            total += self._pytest(name, paths, staged, **python_with_sanitizers())
        return total + self._ctest(
            self.build / "sanitize" / "thread", "sanitize-threads", **THREAD_SANITIZER
        )

    def compilers(self) -> Count:
        """The C++ tests built by other compilers and for other systems, run in emulators."""
        total = Count()
        for preset in ("gcc", "clang", "aarch64", "mingw"):
            count = self._ctest(
                self.build / "compilers" / preset, f"compilers-{preset}", **{SLOW: "1"}
            )
            print(f"NOTE {preset}: {count.passed} passed, {count.failed} failed")
            total += count
        return total

    def cases(self) -> Count:
        """Inputs on which the program once failed, each with its right result."""
        return self._pytest("cases", ["tests/cases"], self.staged)

    def workbench(self) -> Count:
        """The staged tests, inside FreeCAD without a window."""
        if not (self.staged / "freecad" / "sheetmorph" / "tests" / "all.py").is_file():
            return missing("no workbench tests are staged")
        code, output = self._call(
            ["freecadcmd", "-t", "freecad.sheetmorph.tests.all"],
            FREECAD_USER_HOME=str(self.results / "home"),
        )
        return read_unittest(code, output)

    def gui(self) -> Count:
        """The GUI tests on virtual displays; their runner closes with `gui: N passed`."""
        return self._gui()

    def scale(self) -> Count:
        """What FreeCAD takes with many parts and large ones; the lines `NOTE` tell it."""
        return self._gui("large", SHEETMORPH_GUI_LANES="1")

    def vandal(self) -> Count:
        """Anything in any order to panels and documents, by chance: 1,000 acts if not told."""
        acts = os.environ.get("SHEETMORPH_VANDAL_ACTS", "1000")
        return self._gui("vandal", SHEETMORPH_GUI_LANES="1", SHEETMORPH_VANDAL_ACTS=acts)

    def stop(self) -> None:
        """Ends what is running."""
        for process in self._running:
            process.terminate()

    def slurm(self) -> Count:
        """Studies that are killed at random moments; one as an array job of Slurm's own daemons."""
        return self._pytest("batch", ["tests/batch"], self.staged)

    def decks(self) -> Count:
        """Every public deck bent by 5 % of its size, and the joints of sets 01 and 02."""
        return self._pytest(
            "decks",
            ["tests/decks/test_bent_decks.py", "tests/decks/test_real_joints.py"],
            self.staged,
        )

    def fuzz(self) -> Count:
        """Every reader of decks and of files of welds on mutated files, each for 10 minutes of the
        processor."""
        place, seconds = "tests/decks/test_fuzzed_files.py", os.environ.get(FUZZED, "600")
        return self._pytest("fuzz", [place], self.staged, **{FUZZED: seconds})

    def million(self) -> Count:
        """A deck of 1,000,000 nodes in every format; the lines `NOTE` are its table."""
        return self._pytest("million", ["-s", "tests/decks/test_million_nodes.py"], self.staged)

    def shapes(self) -> Count:
        """CAD parts bent and written as CAD again; its log has the table. Minutes."""
        return self._pytest("shapes", ["-s", "tests/shapes"], self.staged)

    def real(self) -> Count:
        """`init` and `run` on all public files, and one recipe in words at three edge lengths."""
        return self._pytest("real", ["tests/real"], self.staged)

    def mutants(self) -> Count:
        """Mistakes planted in the kernel, of which its tests must notice 95 %; takes a quarter of
        an hour. Its log is the table; an interrupted run continues."""
        command = [PYTHON, "-B", "tests/mutants/run_mutants.py", str(self.build)]
        return self._checked([command], **{SLOW: "1"})

    def style(self) -> Count:
        """Formatting, names, habits and types; one test a checker."""
        cpp = sources((".h", ".cpp"), ("core", "bindings", "tests"))
        python = sources((".py",), ("bindings", "Mod", "resources", "tests"))
        checkers = {
            "clang-format": ["clang-format", "--dry-run", "-Werror", *cpp],
            "black": [PYTHON, "-m", "black", "--check", "--line-length", "100", *python],
            "mypy": ["mypy", "--python-executable", PYTHON, "--package", "sheetmorph"]
            + ["--cache-dir", str(self.build / "mypy")],
        }
        checks, skipped = [[PYTHON, "-m", "flake8", *python]], Count()
        for name, check in checkers.items():
            if judges_as_here(name):
                checks.append(check)
            else:
                print(f"skipped: this {name} judges otherwise than {CHECKED_BY[name]}.x")
                skipped += Count(skipped=1)
        return self._checked(checks, MYPYPATH=str(self.staged)) + skipped

    def tidy(self) -> Count:
        """clang-tidy over the kernel and the bindings: minutes, so not among the default suites."""
        return self._checked([[PYTHON, "-B", "tests/style/tidy.py", str(self.build)]])

    def pictures(self) -> Count:
        """Takes the pictures of panels in the user guide anew, in its folder; look at them."""
        folder = ROOT / "resources" / "docs" / "pictures"
        return self._gui("pictures", SHEETMORPH_PICTURES=str(folder))

    def _gui(self, *tests: str, **settings: str) -> Count:
        runner = ROOT / "tests" / "gui" / "run.sh"
        if not runner.is_file():
            return missing("tests/gui/run.sh is missing")
        code, output = self._call(["bash", str(runner), str(self.staged), *tests], **settings)
        return read_closing_line(code, output)

    def _ctest(self, build: Path, name: str, **settings: str) -> Count:
        """The C++ tests of a build; a test counts as failed if its program reports anything."""
        report = self.results / f"{name}.xml"
        report.unlink(missing_ok=True)
        self._call(
            ["ctest", "--test-dir", str(build), "--output-on-failure", "--output-junit"]
            + [str(report), "-j", str(os.cpu_count() or 1), "--progress"],
            **settings,
        )
        return read_junit(report, f"no C++ test ran in {build}")

    def _pytest(self, name: str, paths: list[str], staged: Path, **settings: str) -> Count:
        """Python tests with a staged package; an interpreter that died wrote no report."""
        report = self.results / f"{name}.xml"
        report.unlink(missing_ok=True)
        self._call(
            [PYTHON, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-ra"]
            + [f"--junitxml={report}", *paths],
            PYTHONPATH=str(staged),
            **settings,
        )
        return read_junit(report, f"no test ran in {paths[0]}")

    def _checked(self, checks: list[list[str]], **settings: str) -> Count:
        total = Count()
        for check in checks:
            code, _ = self._call(check, **settings)
            total += Count(passed=1) if code == 0 else Count(failed=1)
        return total

    def _call(self, command: list[str], **settings: str) -> tuple[int, str]:
        """Runs a command in the repository, shows and returns what it says."""
        said = " ".join(["+", *command[:8], *(["..."] if len(command) > 8 else [])])
        with self._telling:
            self._calls += 1
            log = self.results / f"{self._calls:02d}-{Path(command[0]).name}.log"
            print(said, flush=True)
        environment = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "PYTHONHOME")}
        longest = (
            LONGEST_OF_ALL
            if settings.keys() & {"ASAN_OPTIONS", "TSAN_OPTIONS", FUZZED, SLOW}
            else LONGEST_SUITE
        )
        environment |= {"PYTHONNOUSERSITE": "1", "PYTHONDONTWRITEBYTECODE": "1"} | settings
        try:
            process = subprocess.Popen(
                ["timeout", "--kill-after=10", str(longest), *command],
                cwd=ROOT,
                env=environment,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
            )
        except OSError as error:
            print(error)
            return 127, str(error)
        self._running.append(process)
        output = process.communicate()[0].decode(errors="replace")
        self._running.remove(process)
        log.write_text(output)
        lines = output.rstrip().splitlines()
        # All that went well is in the log; what went wrong is shown.
        shown = lines[-3:] if process.returncode == 0 else lines[-LINES_OF_A_FAILURE:]
        shown = [line for line in lines[:-3] if line.startswith("NOTE ")] + shown
        with self._telling:
            print("\n".join([said.replace("+", "=", 1), *shown]), flush=True)
            self.failures += [line[:300] for line in lines if FAILURE.match(line)]
            self.second_tries += [m.group(1) for line in lines if (m := SECOND_TRY.match(line))]
        return process.returncode, output


def python_with_sanitizers() -> dict[str, str]:
    """Settings under which an interpreter without sanitizers loads modules that have them.

    Their libraries must come first, and the C++ library with them, or no exception is seen. What
    the interpreter itself keeps until its end would be reported as leaks.
    """
    libraries = []
    for name in ("libasan.so", "libubsan.so", "libstdc++.so"):
        found = subprocess.run(
            ["g++", f"-print-file-name={name}"], capture_output=True, text=True, check=True
        )
        libraries.append(str(Path(found.stdout.strip()).resolve()))
    options = ADDRESS_SANITIZER["ASAN_OPTIONS"].replace("detect_leaks=1", "detect_leaks=0")
    return ADDRESS_SANITIZER | {
        "ASAN_OPTIONS": options,
        "LD_PRELOAD": " ".join(libraries),
        "PYTHONMALLOC": "malloc",
    }


def judges_as_here(name: str) -> bool:
    """Whether a checker is of the version whose way the sources have; True if it is missing."""
    try:
        said = subprocess.run([name, "--version"], capture_output=True, text=True).stdout
    except OSError:
        return True  # the check itself says so
    version = re.search(r"\d+\.\d+", said)
    return version is None or f"{version.group()}.".startswith(f"{CHECKED_BY[name]}.")


def sources(endings: tuple[str, ...], folders: tuple[str, ...]) -> list[str]:
    """The source files with these endings, relative to the repository."""
    found = [path for folder in folders for path in (ROOT / folder).rglob("*")]
    return sorted(str(path.relative_to(ROOT)) for path in found if path.suffix in endings)


def missing(reason: str) -> Count:
    """One failure, with its reason said."""
    print(f"FAILED: {reason}", flush=True)
    return Count(failed=1)


def read_junit(report: Path, reason: str) -> Count:
    """Counts of a JUnit file; a failure if there is none or it holds no test."""
    if not report.is_file():
        return missing(f"{reason}: no report was written")
    count = Count()
    for case in ElementTree.parse(report).getroot().iter("testcase"):
        if case.find("failure") is not None or case.find("error") is not None:
            count.failed += 1
        elif case.find("skipped") is not None or case.get("status") in ("notrun", "disabled"):
            count.skipped += 1
        else:
            count.passed += 1
    return count if count != Count() else missing(reason)


def read_unittest(code: int, output: str) -> Count:
    """Counts from the closing lines of unittest; FreeCAD's exit code must agree."""
    ran = re.findall(r"^Ran (\d+) tests?", output, re.MULTILINE)
    if not ran or int(ran[-1]) == 0:
        return missing("no workbench test ran")
    skips = re.findall(r"skipped=(\d+)", output[output.rfind("Ran ") :])
    skipped = int(skips[0]) if skips else 0
    # By name: unittest counts the subtests of one test apart.
    failed = len(set(re.findall(r"^(?:FAIL|ERROR): \S+ \(([^)]+)\)", output, re.MULTILINE)))
    if code != 0 and failed == 0:
        return missing(f"FreeCAD ended with {code}")
    return Count(int(ran[-1]) - failed - skipped, failed, skipped)


def read_closing_line(code: int, output: str) -> Count:
    """Counts from a last line like `gui: 12 passed, 1 failed, 2 skipped`."""
    lines = output.strip().splitlines() or [""]
    words = ("passed", "failed", "skipped", "only at the second try")
    found = re.findall(rf"(\d+) ({'|'.join(words)})", lines[-1])
    numbers = {word: int(number) for number, word in found}
    count = Count(*(numbers.get(word, 0) for word in words))
    if not lines[-1].startswith("gui:") or count.passed == 0:
        return missing("the GUI tests did not close with their counts")
    if code != 0 and count.failed == 0:
        return count + missing(f"the GUI tests ended with {code}")
    return count


def closing_line(counts: dict[str, Count]) -> str:
    """`sheetmorph test: 312 passed, 0 failed, 4 skipped (core 140, python 120, ...)`."""
    total = sum(counts.values(), Count())
    parts = ", ".join(f"{name} {count.passed}" for name, count in counts.items())
    again = f", {total.second} only at the second try" if total.second else ""
    return (
        f"sheetmorph test: {total.passed} passed, {total.failed} failed, "
        f"{total.skipped} skipped{again} ({parts})"
    )


def run_all(suites: Suites, names: list[str]) -> dict[str, Count]:
    """Runs suites by name, the one with windows beside the others; returns their counts."""
    with ThreadPoolExecutor() as pool:
        beside = {name: pool.submit(run_one, suites, name) for name in names if name == "gui"}
        try:
            others = {name: run_one(suites, name) for name in names if name not in beside}
        except BaseException:  # an interrupt, too, waits for what runs beside
            suites.stop()
            raise
    done = others | {name: running.result() for name, running in beside.items()}
    return {name: done[name] for name in names}


def run_one(suites: Suites, name: str) -> Count:
    """Runs a suite and tells its counts and how long it took."""
    start = time.monotonic()
    run: Callable[[], Count] = getattr(suites, name)
    count = run()
    seconds = time.monotonic() - start
    told = f"{count.passed} passed, {count.failed} failed, {count.skipped} skipped"
    print(f"--- {name}: {told} in {seconds:.0f} s", flush=True)
    return count


def main(arguments: list[str]) -> int:
    """Runs the suites; 1 if anything failed."""
    default = ["core", "python", "cases", "workbench", "gui", "style"]
    names = [*default, "tidy", "scale", "pictures", "real", "sanitize", "slurm", "vandal"]
    names += ["decks", "fuzz", "million", "shapes", "mutants", "compilers"]
    parser = argparse.ArgumentParser(prog="./sheetmorph test", description="Runs the tests.")
    parser.add_argument("--build", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("suites", nargs="*", metavar="SUITE", help="of: " + ", ".join(names))
    options = parser.parse_args(arguments)
    unknown = [name for name in options.suites if name not in names]
    if unknown:
        parser.error(f"no suite '{unknown[0]}'; there are {', '.join(names)}")
    suites = Suites(options.build.resolve())
    counts = run_all(suites, options.suites or default)
    for name in suites.second_tries:
        print("passed only at the second try:", name)
    for failure in suites.failures:
        print("failed:", failure)
    print(closing_line(counts))
    return 1 if any(count.failed for count in counts.values()) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
