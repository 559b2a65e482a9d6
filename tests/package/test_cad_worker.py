# SPDX-License-Identifier: LGPL-2.1-or-later
"""The CAD worker ends: with its model, with whoever asked, or in the middle of its work; then one
sentence says so, and what was there stays."""

from __future__ import annotations

import os
import random
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import sheetmorph
from cad_samples import make_cad_samples
from sheetmorph import FileError, cad, read_part
from sheetmorph.cad import worker
from sheetmorph.base.errors import KernelError
from sheetmorph.files.cad_writing import CadWriting, write_model
from sheetmorph.recipe.model import model_of
from sheetmorph.recipe.parts import read_parts

WRITING = CadWriting("step")


@pytest.fixture(scope="module")
def samples(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of CAD files."""
    return make_cad_samples(tmp_path_factory.mktemp("cad"))


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch) -> list[subprocess.Popen[bytes]]:
    """The processes of the workers, in the order in which they start."""
    found: list[subprocess.Popen[bytes]] = []

    class Recorded(subprocess.Popen):  # type: ignore[type-arg]
        def __init__(self, *arguments: object, **keys: object):
            super().__init__(*arguments, **keys)
            found.append(self)

    monkeypatch.setattr(worker.subprocess, "Popen", Recorded)
    return found


def kill(process: subprocess.Popen[bytes]) -> None:
    """End a worker as the system does that is out of memory."""
    os.kill(process.pid, signal.SIGKILL)


def written(model: cad.CadModel, path: Path) -> list[dict]:
    """What a file holds that the model is written to, at rest."""
    return write_model(model, path, [part.points for part in model.parts], WRITING)


def is_running(pid: int) -> bool:
    """Whether there is such a process, and it has not ended."""
    try:
        return "\nState:\tZ" not in Path(f"/proc/{pid}/status").read_text()
    except FileNotFoundError:
        return False


def wait_until_ended(pid: int) -> bool:
    """Whether a process ends within ten seconds."""
    for _ in range(100):
        if not is_running(pid):
            return True
        time.sleep(0.1)
    return False


def test_a_worker_that_ends_while_it_reads_is_one_sentence(samples: Path, started: list):
    with pytest.raises(FileError) as caught:
        read_part(samples / "plate.brep", progress=lambda *_: kill(started[0]) or True)
    assert caught.value.what == (
        "the CAD worker ended unexpectedly while it read the file (killed)"
    )
    assert "try again" in caught.value.todo and "\n" not in str(caught.value)
    assert len(read_part(samples / "plate.brep").mesh.triangles) > 100


def test_a_worker_that_ends_while_it_writes_is_one_sentence_and_the_model_can_be_written_again(
    samples: Path, tmp_path: Path, started: list
):
    model = read_part(samples / "fixture.step").model
    positions = [part.points for part in model.parts]
    with pytest.raises(FileError, match="ended unexpectedly while it wrote the shapes"):
        write_model(
            model, tmp_path / "a.step", positions, WRITING,
            progress=lambda *_: kill(started[0]) or True,
        )  # fmt: skip
    bodies = written(model, tmp_path / "b.step")
    assert [body["name"] for body in bodies] == ["plate", "pin", "pin 2"]
    assert all(body["is_valid"] and body["distance"]["value"] < 1e-6 for body in bodies)


def test_a_crash_names_its_signal(samples: Path, started: list):
    with pytest.raises(FileError, match=r"\(segmentation fault\)"):
        read_part(
            samples / "plate.brep",
            progress=lambda *_: os.kill(started[0].pid, signal.SIGSEGV) or True,
        )


def test_shapes_are_read_again_if_their_worker_has_ended_meanwhile(
    samples: Path, tmp_path: Path, started: list
):
    model = read_part(samples / "plate.brep").model
    kept = model.kept_mesh(0), model.brep(0)
    kill(started[0])
    started[0].wait()
    assert (model.kept_mesh(0), model.brep(0)) == kept
    assert len(started) == 2 and written(model, tmp_path / "out.step")[0]["is_valid"]


def test_shapes_that_are_read_again_are_those_of_the_file_as_it_was(
    samples: Path, tmp_path: Path, started: list
):
    path = tmp_path / "part.step"
    shutil.copy(samples / "openings.step", path)
    model = read_part(path).model
    faces = len(model.parts[0].surfaces)
    kill(started[0])
    started[0].wait()
    path.unlink()
    (body,) = written(model, tmp_path / "out.step")
    assert (body["faces"], body["is_valid"]) == (faces, True)


def test_there_are_never_too_many_and_a_model_whose_worker_had_to_go_is_read_again(
    samples: Path, started: list, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(worker, "MOST", 2)
    models = [read_part(samples / "plate.brep").model for _ in range(3)]
    assert [is_running(process.pid) for process in started] == [False, True, True]
    assert models[0].brep(0) == models[2].brep(0)
    assert [is_running(process.pid) for process in started] == [False, False, True, True]


def test_a_worker_ends_with_its_model(samples: Path, started: list):
    model = read_part(samples / "plate.brep").model
    assert is_running(started[0].pid) and len(model.parts) == 1
    del model
    assert wait_until_ended(started[0].pid)


def test_a_worker_ends_when_nobody_wants_to_wait(samples: Path, started: list):
    with pytest.raises(RuntimeError, match="cancelled"):
        read_part(samples / "fixture.step", progress=lambda *_: False)
    assert not is_running(started[0].pid)


def test_what_the_listener_raises_is_raised(samples: Path, started: list):
    def told(*_: object) -> bool:
        raise OSError("no window")

    with pytest.raises(OSError, match="no window"):
        read_part(samples / "fixture.step", progress=told)
    assert not is_running(started[0].pid)


# It reads a file over and over, or has read one and waits; says which worker it has.
_ASKING = """
import subprocess, sys
from sheetmorph import read_part
from sheetmorph.cad import worker
class Told(subprocess.Popen):
    def __init__(self, *arguments, **keys):
        super().__init__(*arguments, **keys)
        print(self.pid, flush=True)
worker.subprocess.Popen = Told
file = read_part(sys.argv[1], {"edge": float(sys.argv[2])})
print("read", flush=True)
input()
"""


def asking(path: Path, edge: float) -> subprocess.Popen[str]:
    """Another process that reads a file."""
    return subprocess.Popen(
        [sys.executable, "-c", _ASKING, str(path), str(edge)],
        env={**os.environ, "PYTHONPATH": str(Path(sheetmorph.__file__).parent.parent)},
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    )  # fmt: skip


@pytest.mark.parametrize("edge", [8.0, 0.1], ids=["idle", "at work"])
def test_a_worker_ends_when_the_process_that_asked_is_killed(samples: Path, edge: float):
    with asking(samples / "fixture.step", edge) as process:
        pid = int(process.stdout.readline())
        if edge > 1.0:
            assert process.stdout.readline() == "read\n"
        assert is_running(pid)
        process.kill()
        assert wait_until_ended(pid)


def test_a_process_that_is_forked_has_a_worker_of_its_own(samples: Path, started: list):
    model = read_part(samples / "plate.brep").model
    kept = model.kept_mesh(0)
    child = os.fork()
    if child == 0:
        os._exit(0 if model.kept_mesh(0) == kept and len(started) == 2 else 1)
    assert os.waitpid(child, 0)[1] == 0
    assert model.kept_mesh(0) == kept and len(started) == 1


def test_without_the_program_one_sentence_says_what_to_do(
    samples: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(worker, "PROGRAM", samples / "sheetmorph-cad")
    with pytest.raises(KernelError, match=r"sheetmorph-cad: No such file.*build and stage it"):
        read_part(samples / "plate.brep")


def test_two_threads_may_ask_one_model(samples: Path):
    model = read_part(samples / "fixture.step").model
    wanted = [(model.kept_mesh(k), model.brep(k)) for k in range(3)]
    found: dict[int, tuple] = {}

    def ask(k: int) -> None:
        found[k] = model.kept_mesh(k), model.brep(k)

    threads = [threading.Thread(target=ask, args=(k,)) for k in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [found[k] for k in range(3)] == wanted


def test_a_size_that_there_is_not_is_named(samples: Path):
    with pytest.raises(KeyError, match="edge, deflection and angle, not length"):
        cad.read_cad(str(samples / "plate.brep"), {"length": 1.0})


def test_arrays_are_read_only(samples: Path):
    part = read_part(samples / "plate.brep").model.parts[0]
    with pytest.raises(ValueError, match="read-only"):
        part.points[0] = 0.0
    assert part.points.dtype == np.float64 and part.triangles.dtype == np.int32


def test_the_cad_files_of_a_recipe_are_read_at_once_and_a_bad_one_costs_nothing_else(
    samples: Path, started: list
):
    files = ("plate.brep", "none.step", "openings.step")
    entries = [{"file": file, "name": file} for file in files]
    parts = read_parts(model_of({"parts": entries}).parts, samples)
    assert [fault.what for fault in parts.faults] == ["the file does not exist"]
    assert len(started) == 2
    for source, file in zip(parts.sources, ("plate.brep", "openings.step")):
        alone = read_part(samples / file).mesh
        assert source.file.path.name == file
        assert np.array_equal(source.file.mesh.points, alone.points)
        assert np.array_equal(source.file.mesh.triangles, alone.triangles)


@pytest.mark.parametrize(
    ("sizes", "words"),
    [
        ({"edge": 1e-3}, "edges of 0.001 mm would need 1.1.e.04 million triangles, the limit is 3"),
        ({"deflection": 1e-6}, "a deflection of 1e-06 mm is too small"),
    ],
)
def test_a_mesh_that_is_too_large_is_refused_with_its_size(samples: Path, sizes: dict, words: str):
    with pytest.raises(FileError, match=words):
        read_part(samples / "plate.brep", sizes)


# The command runs on, its worker is killed: the last words are one sentence, no file is left.
def test_a_command_whose_worker_is_killed_at_any_moment_says_one_sentence(
    samples: Path, tmp_path: Path
):
    path, chance = tmp_path / "fixture.step", random.Random(38)
    shutil.copy(samples / "fixture.step", path)
    command = [sys.executable, "-m", "sheetmorph", "find", str(path)]
    settings = {**os.environ, "PYTHONPATH": str(Path(sheetmorph.__file__).parent.parent)}
    for _ in range(20):
        with subprocess.Popen(
            command, env=settings, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        ) as process:
            pid = worker_of(process)
            time.sleep(chance.uniform(0.0, 0.15))
            os.kill(pid, signal.SIGKILL)
            _, error = process.communicate(timeout=60)
        lines = error.splitlines()
        if process.returncode != 0:  # it was not read yet
            assert process.returncode == 2 and len(lines) == 1, error
            assert "the CAD worker ended unexpectedly while it read the file (killed)" in error
        assert list(tmp_path.iterdir()) == [path]


def worker_of(process: subprocess.Popen[str]) -> int:
    """The worker that a command starts."""
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
    for _ in range(6000):
        for child in children.read_text().split():
            if Path(f"/proc/{child}/comm").read_text() == "sheetmorph-cad\n":
                return int(child)
        time.sleep(0.01)
    raise AssertionError("the command starts no worker")
