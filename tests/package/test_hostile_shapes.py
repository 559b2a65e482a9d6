# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP, IGES and BREP: cut off, with changed bytes, in inches, oddly named, not to be written."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from cad_samples import made_by_freecad
from sheetmorph import read_part, run
from sheetmorph.cli import main

MESH = {"edge": 8.0, "deflection": 0.2, "angle": 20}
FILES = ("plate.step", "plate.igs", "plate.brep")
_SCRIPT = """
plate = Part.makeBox(60, 40, 2).cut(Part.makeCylinder(5, 4, Vector(40, 20, -1)))
plate.exportStep(os.path.join(folder, "plate.step"))
plate.exportIges(os.path.join(folder, "plate.igs"))
plate.exportBrep(os.path.join(folder, "plate.brep"))
Part.setStaticValue("write.iges.unit", "INCH")
plate.exportIges(os.path.join(folder, "inches.igs"))
"""
# Reads a file as it was damaged in one way after the other, each in a process of its own, as one
# meets them; says how many were refused. What a reader refuses it must refuse in words.
_READING = """
import os
import random
import signal
import sys
import traceback
from pathlib import Path
from sheetmorph import read_part
from sheetmorph.errors import FileError

path, whole, kind = Path(sys.argv[1]), Path(sys.argv[1]).read_bytes(), sys.argv[2]

def cut_off():
    return [whole[: len(whole) * k // 24] for k in range(24)]

def changed():
    for seed in range(100):
        chance, made = random.Random(seed), bytearray(whole)
        for _ in range(chance.choice((1, 3, 10, 40))):
            is_plain = chance.random() < 0.8
            byte = chance.choice(b"0123456789#,()$*'ABC.") if is_plain else chance.randrange(256)
            made[chance.randrange(len(made))] = byte
        yield bytes(made)

def read(made):
    path.write_bytes(made)
    try:
        read_part(path, {"edge": 8.0, "deflection": 0.2, "angle": 20})
    except FileError as error:
        assert path.name in str(error), error
        return REFUSED
    return 0

REFUSED, refused = 3, 0
for number, made in enumerate({"cut off": cut_off, "changed": changed}[kind]()):
    child = os.fork()
    if child == 0:
        signal.alarm(100)  # one that reads forever
        status = 1
        try:
            status = read(made)
        except BaseException:
            traceback.print_exc()
        finally:
            os._exit(status)
    status = os.waitpid(child, 0)[1]
    assert status in (0, REFUSED << 8), f"file {number}: it ended with status {status}"
    refused += status != 0
print("refused", refused)
"""


@pytest.fixture(scope="module")
def samples(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with one plate in every format."""
    folder = tmp_path_factory.mktemp("plates")
    made_by_freecad(_SCRIPT, folder)
    return folder


def lifted(folder: Path, file: str, write: str) -> Path:
    """A recipe that lifts one end of a plate, written in a format."""
    x = read_part(folder / file, MESH).mesh.points[:, 0]
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate", "file": file, "mesh": MESH, "write": write}],
        "fixed": [{"part": "plate", "vertices": np.flatnonzero(x < 1e-6).tolist()}],
        "handles": [
            {"name": "tip", "part": "plate", "vertices": np.flatnonzero(x > 59.999).tolist()}
        ],
        "pose": {"tip": {"translation": [0, 0, 4]}},
    }
    path = folder / "recipe.json"
    path.write_text(json.dumps(recipe), "utf-8")
    return path


def refused(path: Path, kind: str) -> int:
    """How many of the files that are damaged in a way the reader refuses; it survives them all."""
    done = subprocess.run(
        [sys.executable, "-c", _READING, str(path), kind],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        stdin=subprocess.DEVNULL, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr[-2000:]
    return int(done.stdout.split()[-1])


@pytest.mark.parametrize("file", FILES)
def test_files_that_are_cut_off_are_refused_in_words(file: str, samples: Path, tmp_path: Path):
    assert refused(Path(shutil.copy(samples / file, tmp_path)), "cut off") > 12


@pytest.mark.parametrize("file", FILES)
def test_files_with_changed_bytes_end_no_process(file: str, samples: Path, tmp_path: Path):
    """OpenCASCADE follows null pointers in some, and goes round in circles in others."""
    assert refused(Path(shutil.copy(samples / file, tmp_path)), "changed") > 10


def test_faces_that_cannot_be_read_are_told(samples: Path, tmp_path: Path):
    """The hole's cylinder stands nowhere in the file."""
    text = (samples / "plate.step").read_text("ascii")
    (surface,) = re.findall(r"#(\d+) = CYLINDRICAL_SURFACE", text)
    damaged = tmp_path / "damaged.step"
    damaged.write_text(text.replace(f"#{surface},.F.)", "#99999,.F.)"), "ascii")
    (solid,) = re.findall(r"(#\d+) = MANIFOLD_SOLID_BREP", text)
    told = "1 face of the file is missing, of {}: OpenCASCADE cannot read them; "
    told += "export the file again"
    assert told.format(solid) in read_part(damaged, MESH).missing
    named = damaged.read_text("ascii").replace(
        "MANIFOLD_SOLID_BREP(''", "MANIFOLD_SOLID_BREP('lid'"
    )
    damaged.write_text(named, "ascii")
    assert told.format("lid") in read_part(damaged, MESH).missing
    for file in FILES:
        assert "missing" not in " ".join(read_part(samples / file, MESH).missing), file


@pytest.mark.parametrize(("file", "write"), list(zip(FILES, ("step", "iges", "brep"))))
def test_names_of_any_script_are_read_and_written(
    file: str, write: str, samples: Path, tmp_path: Path
):
    folder = tmp_path / "Träger für плиты 板"
    folder.mkdir()
    named = "Blech ü ж 板" + Path(file).suffix
    shutil.copy(samples / file, folder / named)
    report = run(lifted(folder, named, write), folder / "fertig é")
    written = report["parts"][0]["shape"]["file"]
    after = read_part(folder / "fertig é" / written, MESH).mesh.points
    assert np.ptp(after[:, 2]) == pytest.approx(6.0, abs=0.3)


def test_iges_in_inches_is_as_large_as_it_says(samples: Path, tmp_path: Path):
    shutil.copy(samples / "inches.igs", tmp_path)
    assert np.ptp(read_part(tmp_path / "inches.igs", MESH).mesh.points[:, 0]) == pytest.approx(60)
    run(lifted(tmp_path, "inches.igs", "iges"), tmp_path / "out")
    after = read_part(tmp_path / "out" / "inches.igs", MESH).mesh.points
    assert np.ptp(after[:, 1]) == pytest.approx(40.0, abs=0.3)


@pytest.mark.parametrize(("file", "write"), list(zip(FILES, ("step", "iges", "brep"))))
def test_a_folder_that_cannot_be_written_is_told(
    file: str, write: str, samples: Path, tmp_path: Path, capsys: pytest.CaptureFixture
):
    shutil.copy(samples / file, tmp_path)
    recipe = lifted(tmp_path, file, write)
    (tmp_path / "taken").write_text("a file, no folder")
    before = sorted(tmp_path.rglob("*"))
    assert main(["run", str(recipe), "-o", str(tmp_path / "taken" / "out"), "--quiet"]) not in (
        0,
        3,
    )
    told = capsys.readouterr().err
    assert "taken" in told and "Traceback" not in told, told
    assert sorted(tmp_path.rglob("*")) == before
