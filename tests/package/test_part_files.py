# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds for the files of every format."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from part_samples import OBJ, moved
from sheetmorph import FileError, read_part

IS_MESHIO = (".vtk", ".vtu")


def test_a_part_at_rest_comes_back_byte_for_byte(sample: Path, tmp_path: Path):
    part = read_part(sample)
    out = tmp_path / "out" / sample.name
    out.parent.mkdir()
    part.write(out, part.mesh.points)
    if sample.suffix in IS_MESHIO:
        again = read_part(out).mesh
        assert np.array_equal(again.points, part.mesh.points)
        assert np.array_equal(again.triangles, part.mesh.triangles)
    else:
        assert out.read_bytes() == sample.read_bytes()


def test_a_deformed_part_reads_back_with_the_error_its_format_has(sample: Path, tmp_path: Path):
    part = read_part(sample)
    positions = moved(part.mesh.points)
    out = tmp_path / ("new" + sample.suffix)
    part.write(out, positions)
    allowed = {"double": 0.0, "float32": 2e-7, "8 characters": 2e-6, "16 characters": 1e-13}
    error = part.read_back_error(out, positions)
    assert error <= allowed[part.precision]
    assert read_part(out).mesh.triangles.shape == part.mesh.triangles.shape
    assert read_part(out).precision == part.precision


def test_writing_leaves_the_file_alone_and_no_temporary_behind(sample: Path, tmp_path: Path):
    before = sample.read_bytes()
    part = read_part(sample)
    out = tmp_path / ("new" + sample.suffix)
    part.write(out, moved(part.mesh.points))
    assert sample.read_bytes() == before
    assert sorted(os.listdir(tmp_path)) == sorted([sample.name, out.name])


def test_one_moved_vertex_changes_its_own_numbers_only(sample: Path, tmp_path: Path):
    part = read_part(sample)
    positions = part.mesh.points.copy()
    positions[1, 0] += 0.123
    out = tmp_path / ("new" + sample.suffix)
    part.write(out, positions)
    stored = part.stored_positions(out)
    assert np.array_equal(np.delete(stored, 1, axis=0), np.delete(part.mesh.points, 1, axis=0))
    assert stored[1, 0] == pytest.approx(positions[1, 0], abs=1e-6)
    assert np.array_equal(stored[1, 1:], positions[1, 1:])


@pytest.mark.parametrize("shape", [(3, 3), (5, 2)])
def test_positions_of_another_shape_are_refused(shape, tmp_path: Path):
    path = tmp_path / "part.obj"
    path.write_bytes(OBJ)
    with pytest.raises(ValueError, match=r"positions must be \(5, 3\)"):
        read_part(path).write(tmp_path / "out.obj", np.zeros(shape))
    assert not (tmp_path / "out.obj").exists()


def test_positions_that_are_not_finite_are_refused(sample: Path, tmp_path: Path):
    part = read_part(sample)
    positions = part.mesh.points.copy()
    positions[0, 0] = np.nan
    with pytest.raises(ValueError, match="not a finite number; nothing was written"):
        part.write(tmp_path / ("out" + sample.suffix), positions)
    assert os.listdir(tmp_path) == [sample.name]


@pytest.mark.parametrize(
    ("name", "what"),
    [
        ("part.step", "the file does not exist"),
        ("part.fcstd", 'unknown format ".fcstd", a document of FreeCAD'),
        ("part.SLDPRT.gz", 'unknown format ".SLDPRT", a file of a CAD program'),
        ("part.what", 'unknown format ".what"'),
        ("missing.obj", "the file does not exist"),
        (".", "it is a folder"),
    ],
)
def test_a_file_that_cannot_be_a_part_says_why(name: str, what: str, tmp_path: Path):
    with pytest.raises(FileError) as caught:
        read_part(tmp_path / name)
    assert caught.value.what == what
    assert caught.value.todo
    assert str(tmp_path / name) in str(caught.value)
