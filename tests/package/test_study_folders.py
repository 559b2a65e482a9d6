# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of a study: nothing finished and nothing foreign is lost, whoever dies meanwhile."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from plates import plate, write_plate
from sheetmorph import FileError, OccupiedError, RecipeError
from sheetmorph.study.leases import Lease, alone, among_others, is_abandoned
from sheetmorph.study.rows import ERROR, FILE, PASSED, Row
from sheetmorph.study.running import Ways, run_study
from sheetmorph.study.storing import Store, write_json

COUNT = 6


@pytest.fixture
def study(tmp_path: Path) -> Path:
    """A study of a few variants of a plate."""
    made = plate()
    write_plate(made, tmp_path / "plate.obj", "obj")
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate", "file": "plate.obj"}],
        "fixed": [{"part": "plate", "vertices": made.left}],
        "handles": [{"name": "tip", "part": "plate", "vertices": made.right}],
        "pose": {"tip": {"translation": [0, 0, 2]}},
    }
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    entries = {
        "sheetmorph_study": 1,
        "recipe": "recipe.json",
        "parameters": {"lift": {"path": "pose.tip.translation[2]", "range": [0, 10]}},
        "sampling": {"method": "latin hypercube", "count": COUNT, "seed": 1},
        "measure": {"tip": {"position": "tip"}},
        "write": ["parts", "certificate"],
    }
    path = tmp_path / "study.json"
    path.write_text(json.dumps(entries))
    return path


def with_seed(study: Path, seed: int) -> None:
    """The study with other samples."""
    entries = json.loads(study.read_text())
    entries["sampling"]["seed"] = seed
    study.write_text(json.dumps(entries))


def contents(out: Path) -> dict[str, bytes]:
    """Every file that does not differ from call to call."""
    files = (file for file in sorted(out.rglob("*")) if file.is_file())
    named = {str(file.relative_to(out)): file for file in files}
    own = ("costs.json", ".lock")
    return {name: file.read_bytes() for name, file in named.items() if name not in own}


@pytest.mark.parametrize(
    "files",
    [
        {"thesis.txt": "precious"},
        {"parameters.json": '{"mine": 1}', "thesis.txt": "precious"},
        {"parameters.json": "not JSON"},
        {"sub/thesis.txt": "precious"},
    ],
)
def test_a_folder_of_the_user_where_a_variant_belongs_is_refused_and_stays(files, study: Path):
    out = study.parent / "out"
    for name, text in files.items():
        (out / "000001" / name).parent.mkdir(parents=True, exist_ok=True)
        (out / "000001" / name).write_text(text)
    with pytest.raises(FileError, match="000001: a variant belongs there"):
        run_study(study, out)
    for name, text in files.items():
        assert (out / "000001" / name).read_text() == text
    assert not (out / "000000").exists()


def test_notes_in_a_variant_stay_and_a_study_that_would_lose_them_is_refused(study: Path):
    out = study.parent / "out"
    run_study(study, out)
    note = out / "000001" / "thesis.txt"
    note.write_text("precious")
    assert run_study(study, out).computed == 0
    with_seed(study, 2)
    with pytest.raises(FileError, match="thesis.txt"):
        run_study(study, out)
    assert note.read_text() == "precious"
    note.unlink()
    mesh = out / "000002" / "plate.obj"
    mesh.write_text(mesh.read_text() + "# smoothed by hand\n")
    with pytest.raises(FileError, match="plate.obj"):
        run_study(study, out)
    assert mesh.read_text().endswith("by hand\n")


def test_a_variant_that_lost_a_file_is_computed_again(study: Path):
    out = study.parent / "out"
    run_study(study, out)
    before = contents(out)
    (out / "000001" / "plate.obj").write_text("")
    (out / "000003" / "certificate.json").unlink()
    assert run_study(study, out).computed == 2
    assert contents(out) == before


def test_a_variant_with_an_error_is_replaced_by_the_next_try(tmp_path: Path):
    store = Store(tmp_path)
    for status in (ERROR, PASSED, ERROR):
        with store.folder(0) as folder:
            write_json(folder, {FILE: Row("same", {}, status).to_json()})
    assert store.row(0, "same").status == PASSED


def test_finished_variants_of_other_settings_are_kept_and_come_back(study: Path):
    out = study.parent / "out"
    run_study(study, out)
    first = contents(out)
    with_seed(study, 2)
    told = run_study(study, out).sentences
    assert f"{COUNT} finished variants with other settings stay" in told[1]
    with_seed(study, 1)
    assert run_study(study, out).computed == 0
    assert {name: data for name, data in contents(out).items() if name[0] != "."} == first


@pytest.mark.parametrize("name", ["summary.csv", "summary.html", "costs.json", "Snakefile"])
def test_a_summary_of_somebody_else_stays(name: str, study: Path):
    out = study.parent / "out"
    out.mkdir()
    (out / name).write_text("precious")
    with pytest.raises(OccupiedError, match=name):
        run_study(study, out)
    assert (out / name).read_text() == "precious" and not (out / "000000").exists()
    (out / name).unlink()
    assert run_study(study, out).computed == COUNT
    assert run_study(study, out).computed == 0


def test_a_study_gives_its_rows(study: Path):
    rows = run_study(study, study.parent / "out")
    table = json.loads((study.parent / "out" / "summary.json").read_text())
    assert [row.parameters for row in rows] == [run["parameters"] for run in table["runs"]]
    assert {row.status for row in rows} == {"passed"} and len(rows) == COUNT
    assert repr(rows) == f"<StudyRows: {COUNT} passed>" and f"{COUNT} computed" in str(rows)
    (name,) = rows[0].parameters
    assert str(rows[0]) == f"{name} = {rows[0].parameters[name]:.6g}: passed"
    some = run_study(study, study.parent / "some", Ways(runs=(1, 2)))
    assert [row.hash for row in some] == [row.hash for row in rows[1:3]]


def test_half_written_tables_of_a_call_that_was_killed_go_and_files_like_them_stay(study: Path):
    out = study.parent / "out"
    run_study(study, out)
    names = ["summary.csv", "summary.json", "summary.html", "costs.json"]
    half_written = [out / f".{name.replace('.', '.0123abcd.tmp.')}" for name in names]
    foreign = [out / ".summary.0123abcd.csv", out / ".summary.notes.tmp.csv", out / ".notes"]
    for path in half_written + foreign:
        path.write_text("half a table")
    run_study(study, out)
    assert [path for path in half_written + foreign if path.exists()] == foreign


def test_a_lock_that_is_a_pipe_is_refused(study: Path):
    out = study.parent / "out"
    out.mkdir()
    os.mkfifo(out / ".lock")
    for ways in (Ways(), Ways(runs=(0, 1))):
        with pytest.raises(FileError, match="it is a device or a pipe"):
            run_study(study, out, ways)


def test_calls_for_some_runs_work_beside_each_other_and_none_beside_a_whole_call(
    tmp_path: Path, monkeypatch
):
    monkeypatch.setattr("sheetmorph.study.leases._PATIENCE", 0.0)
    with among_others(tmp_path), among_others(tmp_path):
        with pytest.raises(RecipeError, match="another process"), alone(tmp_path):
            pass
    with alone(tmp_path):
        with pytest.raises(RecipeError, match="another process"), among_others(tmp_path):
            pass
    with alone(tmp_path):
        assert (tmp_path / ".lock").is_file()


def test_a_lease_ends_with_its_process(tmp_path: Path):
    lease, folder = tmp_path / "a.lease", tmp_path / "a.tmp"
    folder.mkdir()
    with Lease(lease):
        assert not is_abandoned(lease, folder)
    assert not lease.exists() and not is_abandoned(lease, folder)
    hold = (
        "import sys, time; from pathlib import Path; from sheetmorph.study.leases import Lease\n"
        "with Lease(Path(sys.argv[1])): print('held', flush=True); time.sleep(60)"
    )
    with subprocess.Popen(
        [sys.executable, "-c", hold, str(lease)], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None and process.stdout.readline() == "held\n"
        assert not is_abandoned(lease, folder)
        process.kill()
    assert is_abandoned(lease, folder)


def calls(study: Path, out: Path, draw: random.Random) -> list[subprocess.Popen]:
    """Calls that compute the study beside each other: for all of it, or for some of its runs."""
    line = [sys.executable, "-m", "sheetmorph", "study", str(study), "-o", str(out), "--quiet"]
    first = draw.randrange(COUNT)
    ways = (["--engine", "processes", "--workers", "5"], ["--runs", f"{first}-{COUNT - 1}"])
    return [
        subprocess.Popen(
            [*line, *draw.choice(ways)],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
        )
        for _ in range(2)
    ]  # fmt: skip


@pytest.mark.parametrize("seed", range(2))
def test_two_calls_killed_at_random_give_one_result_and_leave_what_is_foreign(
    seed: int, study: Path
):
    draw, out = random.Random(seed), study.parent / "out"
    run_study(study, study.parent / "expected")
    out.mkdir()
    (out / "notes").mkdir()
    (out / "notes" / "thesis.txt").write_text("precious")
    for _ in range(4):
        at_work = calls(study, out, draw)
        time.sleep(draw.uniform(0.3, 1.5))
        for process in at_work:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
        done = [path for path in out.glob("0*") if path.is_dir()]
        assert all((path / "parameters.json").is_file() for path in done)
    run_study(study, out)
    found = contents(out)
    assert found.pop("notes/thesis.txt") == b"precious"
    assert found == contents(study.parent / "expected")
