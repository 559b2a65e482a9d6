# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a study is computed does not matter: the same files, whatever dies on the way."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from pathlib import Path
from types import FrameType

import pytest

import sheetmorph
from sheetmorph.cli import main
from sheetmorph.study.engines import driving
from sheetmorph.study.engines.driving import Driver, Hopes, Pool
from sheetmorph.study.engines.processes import processes_driver
from sheetmorph.study.plan import Plan
from sheetmorph.study.storing import Store
from sheetmorph.study.working import Cost, Task, Workshop, adopt, attempt
from study_samples import contents, rows_of, write_study

MANY = {"method": "halton", "count": 70, "seed": 1}


def whole_study(folder: Path, **keys) -> dict[str, bytes]:
    """The files of a study that nothing disturbed."""
    path = write_study(folder, **keys)
    assert main(["study", str(path), "-o", str(folder / "whole"), "--quiet"]) == 0
    return contents(folder / "whole")


def command_of(folder: Path, *options: str) -> list[str]:
    words = [sys.executable, "-m", "sheetmorph", "study", str(folder / "study.json"), "--quiet"]
    return [*words, "-o", str(folder / "out"), *options]


class Cluster:
    """A Dask scheduler and workers of this machine, on loopback addresses."""

    def __init__(self, folder: Path, workers: int):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self._port = free.getsockname()[1]
        self.address = f"tcp://127.0.0.1:{self._port}"
        self._folder = folder
        self._log = open(folder / "cluster.log", "w", encoding="utf-8")
        self.scheduler = self._start("scheduler", "--port", str(self._port))
        self.workers = [self.add_worker() for _ in range(workers)]

    def _start(self, kind: str, *words: str) -> subprocess.Popen:
        line = [sys.executable, "-m", f"distributed.cli.dask_{kind}", "--host", "127.0.0.1"]
        package = str(Path(sheetmorph.__file__).resolve().parents[1])
        told = {"SHEETMORPH_THREADS": "1", "TMPDIR": str(self._folder), "PYTHONPATH": package}
        environment = {**os.environ, **told}
        return subprocess.Popen(
            [*line, "--no-dashboard", *words], env=environment, stderr=self._log, cwd=self._folder
        )

    def add_worker(self) -> subprocess.Popen:
        return self._start("worker", self.address, "--nthreads", "1", "--no-nanny")

    def restart(self) -> None:
        """Another scheduler at the same address; workers that ended with the old one come back."""
        self.scheduler.kill()
        self.scheduler.wait()
        self.scheduler = self._start("scheduler", "--port", str(self._port))
        end = time.monotonic() + 20
        while any(w.poll() is None for w in self.workers) and time.monotonic() < end:
            time.sleep(0.1)
        self.workers = [w if w.poll() is None else self.add_worker() for w in self.workers]

    def stop(self) -> None:
        for process in (*self.workers, self.scheduler):
            process.kill()
            process.wait()
        self._log.close()


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[Cluster]:
    pytest.importorskip("distributed", reason="python3-distributed is not installed")
    made = Cluster(tmp_path, 4)
    yield made
    made.stop()


def wait_for(done: Callable[[], bool], running: subprocess.Popen) -> None:
    while not done() and running.poll() is None:
        time.sleep(0.01)


def test_a_cluster_that_loses_a_worker_and_its_scheduler_makes_the_same_files(
    tmp_path: Path, cluster: Cluster
):
    whole = whole_study(tmp_path, sampling=MANY)
    line = command_of(tmp_path, "--engine", "dask", "--scheduler", cluster.address)
    with subprocess.Popen(line) as running:
        wait_for(lambda: len(list(tmp_path.glob("out/0*"))) >= 10, running)
        cluster.workers[0].kill()
        wait_for(lambda: len(list(tmp_path.glob("out/0*"))) >= 30, running)
        cluster.restart()
        assert running.wait(120) == 0
    assert contents(tmp_path / "out") == whole
    assert len(rows_of(tmp_path / "out")) == 70


def preprocessed(out: Path) -> int:
    """How often something was pre-processed in the last call of a study."""
    return json.loads((out / "costs.json").read_text())["preprocessed"]


def test_every_worker_of_dask_preprocesses_once(tmp_path: Path):
    pytest.importorskip("distributed", reason="python3-distributed is not installed")
    whole = whole_study(tmp_path, sampling={**MANY, "count": 24})
    assert preprocessed(tmp_path / "whole") == 1
    line = command_of(tmp_path, "--engine", "dask", "--workers", "2")
    done = subprocess.run(line, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert contents(tmp_path / "out") == whole
    assert preprocessed(tmp_path / "out") in (1, 2)


def test_processes_have_what_was_preprocessed_once_for_all(tmp_path: Path):
    path = write_study(tmp_path, sampling={**MANY, "count": 12})
    words = ["study", str(path), "-o", str(tmp_path / "out"), "--quiet"]
    assert main([*words, "--engine", "processes", "--workers", "3"]) == 0
    assert preprocessed(tmp_path / "out") == 1


def test_a_task_of_an_array_preprocesses_once_for_all_its_runs(tmp_path: Path, capsys):
    path = write_study(tmp_path, sampling={**MANY, "count": 12})
    for runs in ("0-5", "6-11"):
        assert main(["study", str(path), "-o", str(tmp_path / "out"), "--runs", runs]) == 0
        assert "6 run(s) done, pre-processed 1 time(s)" in capsys.readouterr().out


def test_threads_of_one_worker_make_the_same_files(tmp_path: Path):
    whole = whole_study(tmp_path, sampling={**MANY, "count": 24})
    plan, out = Plan(tmp_path / "study.json"), tmp_path / "out"
    Store(out).open()
    keys = [plan.hash_of(values) for values in plan.samples]
    study = str(tmp_path / "study.json")
    tasks = [Task(study, str(out), run, key) for run, key in enumerate(keys)]
    adopt(Workshop(plan), study)
    with ThreadPoolExecutor(4) as threads:
        found = list(threads.map(attempt, tasks))
    assert [fault for _, fault in found] == [None] * 24
    assert sum(cost.preprocessed for cost, _ in found) == 1
    made = contents(out)
    assert made and made == {name: whole[name] for name in made}


def test_a_process_that_is_killed_costs_a_try(tmp_path: Path):
    whole = whole_study(tmp_path, sampling=MANY)
    line = command_of(tmp_path, "--engine", "processes", "--workers", "2")
    with subprocess.Popen(line) as running:
        wait_for(lambda: len(list(tmp_path.glob("out/0*"))) >= 5, running)
        workers = children_of(running.pid)
        assert len(workers) == 2
        os.kill(workers[-1], 9)
        assert running.wait(120) == 0
    assert contents(tmp_path / "out") == whole


def children_of(parent: int) -> list[int]:
    """The worker processes of a study."""
    return [int(pid) for pid in Path(f"/proc/{parent}/task/{parent}/children").read_text().split()]


class Told(BaseException):
    """Raised where a command is told to end."""


def tell(_number: int, _frame: FrameType | None) -> None:
    raise Told


def told_to_end_once(task: Task) -> tuple[Cost, str]:
    """Computes nothing; the first time, the pool tells the worker to end, as a broken one does."""
    told = Path(task.out) / "told"
    if not told.exists():
        told.touch()
        signal.raise_signal(signal.SIGTERM)
    return Cost(), ""


def test_a_worker_that_is_told_to_end_ends_whatever_a_command_would_do(tmp_path: Path, monkeypatch):
    finished: list[int] = []
    hopes = Hopes(lambda task, _: finished.append(task.run), print, lambda _: False)
    monkeypatch.setattr(driving, "attempt", told_to_end_once)
    previous = signal.signal(signal.SIGTERM, tell)
    try:
        processes_driver(2, hopes).drive([Task("study", str(tmp_path), 0, "")])
    finally:
        signal.signal(signal.SIGTERM, previous)
    assert finished == [0]


class Fragile(Executor):
    """Computes nothing, and breaks when it is given a certain run."""

    def __init__(self, poison: int, seen: list[int]):
        self._poison, self._seen, self._broken = poison, seen, False

    def submit(self, _function, task: Task) -> Future:
        future: Future = Future()
        self._seen.append(task.run)
        self._broken = self._broken or task.run == self._poison
        if self._broken:
            future.set_exception(BrokenProcessPool("it died"))
        else:
            future.set_result((Cost(), ""))
        return future


def test_a_variant_that_kills_its_workers_is_given_up_and_no_other_one():
    finished, lost, seen = [], [], []
    hopes = Hopes(
        lambda task, _: finished.append(task.run),
        lambda task, why: lost.append((task.run, why)),
        lambda _: False,
    )

    @contextmanager
    def opened() -> Iterator[Pool]:
        yield Pool(Fragile(3, seen), 4)

    tasks = [Task("study", "out", run, "") for run in range(9)]
    Driver(opened, (BrokenProcessPool,), hopes).drive(tasks)
    assert sorted(finished) == [0, 1, 2, 4, 5, 6, 7, 8]
    assert lost == [(3, "its worker process ended 4 times (BrokenProcessPool)")]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--scheduler", "tcp://127.0.0.1:1"), "only the engine dask has a scheduler"),
        (("--engine", "dask", "--scheduler", "nowhere://1"), "no scheduler answers"),
    ],
)
def test_an_engine_that_cannot_be_had_is_told(tmp_path: Path, capsys, options, said):
    path = write_study(tmp_path)
    assert main(["study", str(path), "-o", str(tmp_path / "out"), *options]) == 2
    text = capsys.readouterr().err
    assert said in text and "Traceback" not in text


def test_a_study_that_is_changed_under_its_workers_stops(tmp_path: Path):
    from sheetmorph.study.working import attempt

    path = write_study(tmp_path)
    (tmp_path / "out").mkdir()
    cost, failure = attempt(Task(str(path), str(tmp_path / "out"), 0, "another hash"))
    assert "changed meanwhile" in str(failure) and cost.seconds == 0
    assert json.loads(path.read_text()) and not list((tmp_path / "out").iterdir())
