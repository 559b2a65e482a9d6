# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are cut short, corrupt or nonsense give a FileError and nothing else."""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
import pytest

from part_samples import OBJ, OFF, PLY, STL, NASTRAN, binary_ply, binary_stl, samples
from sheetmorph import FileError, read_part

ENDINGS = (".obj", ".off", ".ply", ".stl", ".nas", ".bdf", ".vtk", ".vtu")


def failure_of(path: Path) -> FileError | None:
    """The FileError of reading a file; None if it can be read, and then its mesh is sound."""
    try:
        mesh = read_part(path).mesh
    except FileError as error:
        assert error.what and error.todo and error.path == path
        assert "\n" not in str(error)
        return error
    assert np.isfinite(mesh.points).all()
    assert mesh.triangles.min() >= 0 and mesh.triangles.max() < len(mesh.points)
    return None


def test_a_file_cut_at_any_byte_is_read_or_refused(sample: Path):
    data = sample.read_bytes()
    step = 7 if sample.suffix == ".vtk" else 1
    refused = 0
    for length in range(0, len(data), step):
        sample.write_bytes(data[:length])
        refused += failure_of(sample) is not None
    assert refused > 0.3 * len(data) / step


def test_a_file_with_random_bytes_changed_is_read_or_refused(sample: Path):
    data = sample.read_bytes()
    noise = random.Random(3)
    refused = 0
    for _ in range(60 if sample.suffix == ".vtk" else 300):
        broken = bytearray(data)
        for _ in range(noise.randint(1, 4)):
            broken[noise.randrange(len(data))] = noise.randrange(256)
        sample.write_bytes(broken)
        refused += failure_of(sample) is not None
    assert refused > 0


@pytest.mark.parametrize("ending", ENDINGS)
@pytest.mark.parametrize("content", [b"", b"\n\n", b"hello", bytes(range(256)) * 3, b"\0" * 84])
def test_nonsense_is_refused_by_every_reader(ending: str, content: bytes, tmp_path: Path):
    path = tmp_path / ("part" + ending)
    path.write_bytes(content)
    assert failure_of(path) is not None


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_file_of_another_format_is_refused(ending: str, tmp_path: Path):
    own = {".bdf": ".nas", ".vtu": ".vtk"}.get(ending, ending)
    for name, content in samples().items():
        other = {".bdf": ".nas"}.get(Path(name).suffix, Path(name).suffix)
        if other != own:
            path = tmp_path / ("part" + ending)
            path.write_bytes(content)
            assert failure_of(path) is not None, name


def replaced(data: bytes, old: bytes, new: bytes) -> bytes:
    """`data` with its first `old` exchanged."""
    assert old in data
    return data.replace(old, new, 1)


MISTAKES = [
    ("a.obj", replaced(OBJ, b"f 1 2 3 4", b"f 1 2 3 9"), 15, "names vertex 9, the file has 5"),
    ("a.obj", replaced(OBJ, b"f 1 2 3 4", b"f 0 2 3"), 15, "names vertex 0"),
    ("a.obj", replaced(OBJ, b"-5/1/1", b"-6/1/1"), 18, "names vertex -6/1/1"),
    ("a.obj", replaced(OBJ, b"f 1 2 3 4", b"f 1 2"), 15, "a face with 2 vertices"),
    ("a.obj", replaced(OBJ, b"v 0 0 0", b"v 0 0"), 4, "2 coordinates instead of 3"),
    ("a.obj", replaced(OBJ, b"v 0 0 0", b"v 0 nan 0"), 4, '"nan" is not a number'),
    ("a.obj", replaced(OBJ, b"v 0 0 0", b"v 0 1_0 0"), 4, '"1_0" is not a number'),
    ("a.obj", replaced(OBJ, b"v 0 0 0", b"v 0 1e999 0"), 4, "too large"),
    ("a.off", replaced(OFF, b"5 3 0", b"6 3 0"), 13, "ends early"),
    ("a.off", replaced(OFF, b"3 4 3 0", b"3 4 3 5"), 12, "names vertex 5"),
    ("a.off", replaced(OFF, b"OFF", b"4OFF"), 1, "not three-dimensional"),
    ("a.off", replaced(OFF, b"OFF", b"OFF BINARY"), 1, "binary OFF is not read"),
    ("a.ply", replaced(PLY, b"ascii", b"utf"), 2, "unknown format"),
    ("a.ply", replaced(PLY, b"float z", b"float w"), 1, "need a property z"),
    ("a.ply", replaced(PLY, b"float z", b"int z"), 1, "need a property z"),
    ("a.ply", replaced(PLY, b"float z", b"quad z"), 8, "unknown type"),
    ("a.ply", replaced(PLY, b"1 3 0 2 3", b"1 3 0 2 4"), 1, "outside 0 .. 3"),
    ("a.ply", replaced(PLY, b"element vertex 4", b"element vertex 9"), 21, "a vertex with 5"),
    ("a.ply", binary_ply("<")[:-1], None, "ends early"),
    ("a.stl", replaced(STL, b"vertex 0 0 0", b"vertex 0 0 x"), 4, '"x" is not a number'),
    ("a.stl", replaced(STL, b"outer loop", b"inner loop"), None, "is not a facet"),
    ("a.stl", replaced(STL, b"endsolid two facets", b"endsolid two\nfacets"), None, "incomplete"),
    ("a.stl", binary_stl()[:-3].replace(b"solid", b"SOLAR"), 1, "3 facets need 234 bytes"),
    ("a.nas", replaced(NASTRAN, b"1.50    1.+0", b"1.50    one "), 8, '"one" is not a number'),
    ("a.nas", replaced(NASTRAN, b"GRID    30 ", b"GRID    10 "), 8, "node 10 is defined twice"),
    ("a.nas", replaced(NASTRAN, b"CTRIA3  2       1       10      40      50",
                       b"CTRIA3  2       1       10      40      51"), 14, "do not exist: 51"),
    ("a.nas", replaced(NASTRAN, b"20      0  ", b"20      3  "), 7, "no coordinate system 3"),
    ("a.nas", replaced(NASTRAN, b"CTRIA3  2       1       10", b"CTRIA3  2       1       1O"),
     14, '"1O" in field 4 is not a whole number'),
]  # fmt: skip


@pytest.mark.parametrize("mistake", MISTAKES, ids=[f"{m[0]}-{m[3]}" for m in MISTAKES])
def test_a_mistake_is_named_with_its_line(mistake: tuple, tmp_path: Path):
    name, data, line, what = mistake
    path = tmp_path / name
    path.write_bytes(data)
    error = failure_of(path)
    assert error is not None
    assert what in error.what
    assert line is None or error.line == line


@pytest.mark.filterwarnings("error")
def test_a_number_that_signals_is_refused_without_a_warning(tmp_path: Path):
    """A NaN with a bit that tells the processor to complain about it."""
    data = bytearray(binary_stl().replace(b"solid", b"SOLAR"))
    data[84 + 12 : 84 + 16] = (0x7FA00000).to_bytes(4, "little")
    path = tmp_path / "a.stl"
    path.write_bytes(data)
    error = failure_of(path)
    assert error is not None and "finite" in error.what, error
