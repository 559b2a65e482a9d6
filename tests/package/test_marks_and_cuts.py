# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts with foreign bytes, and files cut short: the same mesh, a refusal or a word; never another
mesh in silence."""

from __future__ import annotations

import random
import re
from pathlib import Path

import numpy as np
import pytest

from part_samples import samples
from sheetmorph import FileError, read_part
from sheetmorph.certifying.criteria import read_criteria
from sheetmorph.files.part_file import PartFile
from sheetmorph.flat.bends import KTable
from sheetmorph.joint_files import read_joint_bytes
from sheetmorph.recipe.reading import read_json

MARK = b"\xef\xbb\xbf"
TEXTS = ("part.obj", "crlf.obj", "part.off", "coloured.off", "part.ply", "part.stl")
MESHES = (*TEXTS, "little.ply", "big.ply", "binary.stl", "part.vtk", "binary.vtk")
FOREIGN = {
    "mark": MARK,
    "nul": b"\0",
    "line break": b"\n",
    "old line break": b"\r",
    "both": b"\r\n",
    "bytes": b"\xff\xfe\x80",
    "letter": b"q",
    "comment": b"#",
    "continued": b"\\\n",
}


def read(path: Path, data: bytes) -> PartFile | None:
    """The file with these bytes; None if it is refused."""
    path.write_bytes(data)
    try:
        return read_part(path)
    except FileError as error:
        assert error.todo and "\n" not in str(error)
        return None


def is_same(one: PartFile, other: PartFile) -> bool:
    return np.array_equal(one.mesh.points, other.mesh.points) and np.array_equal(
        one.mesh.triangles, other.mesh.triangles
    )


@pytest.mark.parametrize("name", TEXTS)
@pytest.mark.parametrize("kind", FOREIGN)
def test_foreign_bytes_never_make_another_mesh_in_silence(name: str, kind: str, tmp_path: Path):
    data = samples()[name]
    path = tmp_path / name
    plain = read(path, data)
    places = {0, len(data), *random.Random(f"{name} {kind}").sample(range(len(data)), 60)}
    # A comment hides what follows it on the line, whatever that is.
    if kind == "comment":
        places = {k for k in places if data[k - 1 : k] in (b"\n", b"")}
    for k in sorted(places):
        found = read(path, data[:k] + FOREIGN[kind] + data[k:])
        assert found is None or is_same(found, plain) or found.missing, (kind, k)


@pytest.mark.parametrize("name", TEXTS)
def test_a_mark_at_the_start_changes_nothing_and_one_further_on_is_refused_with_its_line(
    name: str, tmp_path: Path
):
    data = samples()[name]
    path = tmp_path / name
    plain = read(path, data)
    marked = read(path, MARK + data)
    assert is_same(marked, plain) and marked.missing == plain.missing
    for foreign, what in ((MARK, "a byte order mark"), (b"\0", "a zero byte")):
        begin = data.index(b"\n", len(data) // 2) + 1
        path.write_bytes(data[:begin] + foreign + data[begin:])
        with pytest.raises(FileError, match=what) as caught:
            read_part(path)
        assert caught.value.line == data.count(b"\n", 0, begin) + 1


@pytest.mark.parametrize("name", TEXTS)
def test_blanks_and_line_ends_of_any_kind_change_nothing(name: str, tmp_path: Path):
    data = samples()[name].replace(b"\r\n", b"\n")
    path = tmp_path / name
    plain = read(path, data)
    noise = random.Random(name)
    for _ in range(20):
        blanks = [b" ", b"\t", b"  \t "]
        body = re.sub(rb"(?<=\S)(?<!\\)\n", lambda m: noise.choice(blanks) + m[0], data)
        # The header of a PLY file decides where its data begin.
        start = body.index(b"end_header") if name.endswith(".ply") else 0
        body = body[:start] + re.sub(
            rb"(?<=\d) (?=[\d.])", lambda m: noise.choice(blanks), body[start:]
        )
        for end in (b"\n", b"\r\n", b"\r"):
            found = read(path, body.replace(b"\n", end))
            assert found is not None and is_same(found, plain)


@pytest.mark.parametrize("name", MESHES)
def test_a_file_cut_short_is_never_a_smaller_part_without_a_word(name: str, tmp_path: Path):
    data = samples()[name]
    path = tmp_path / name
    plain = read(path, data)
    for k in range(0, len(data), 1 if name in TEXTS else 5):
        found = read(path, data[:k])
        if found is None or is_same(found, plain) or found.missing:
            continue
        # An OBJ file has no count and no end. Behind a face that leaves no vertex unused, what is
        # left is another sound file.
        assert name.endswith(".obj") and data[k - 1 : k] in b"\r\n", k


def test_what_a_file_lacks_is_said_with_its_count(tmp_path: Path):
    def missing(name: str, data: bytes) -> str:
        found = read(tmp_path / name, data)
        assert found is not None
        return "; ".join(found.missing)

    obj = samples()["part.obj"]
    assert missing("a.obj", obj) == ""
    assert "1 vertex has no face" in missing(
        "a.obj",
        obj.replace(b"v -1 0 0", b"v -1 0 0\nv 9 9 9")
        .replace(b"-5/", b"-6/")
        .replace(b"-2/", b"-3/")
        .replace(b"-1/", b"-2/"),
    )
    assert '2 statements "surf"' in missing("a.obj", obj + b"surf 0 1 0 1\nsurf 0 1 0 1 1\n")
    assert "without a line break" in missing("a.off", samples()["part.off"].rstrip())
    stl = samples()["binary.stl"]
    for short in (1, 2):
        assert "all 3 facets are there" in missing("a.stl", stl[:-short])
    assert "endsolid is missing" in missing(
        "a.stl", re.sub(rb"endsolid.*", b"", samples()["part.stl"])
    )
    assert "4 bytes follow" in missing("a.ply", samples()["little.ply"] + b"more")


@pytest.mark.parametrize("short", [1, 2])
def test_a_binary_stl_without_its_last_attribute_comes_back_whole(short: int, tmp_path: Path):
    data = samples()["binary.stl"]
    part = read(tmp_path / "a.stl", data[:-short])
    assert is_same(part, read(tmp_path / "b.stl", data))
    part.write(tmp_path / "out.stl", part.mesh.points)
    assert (tmp_path / "out.stl").read_bytes() == data[:-short] + bytes(short)


def test_other_texts_take_a_mark_at_the_start(tmp_path: Path):
    def write(name: str, text: str, mark: bytes) -> Path:
        path = tmp_path / name
        path.write_bytes(mark + text.encode())
        return path

    for read_text, name, text in (
        (read_criteria, "c.json", '{"set": "standard"}'),
        (KTable.read, "k.txt", "0.5 0.3\n2 0.4\n"),
        (read_json, "r.json", '{"sheetmorph": 1}'),
        (read_json, "r.toml", "sheetmorph = 1\n"),
    ):
        plain = read_text(write(name, text, b""))
        assert read_text(write(name, text, MARK)) == plain
    for name, text in (
        ("w.csv", "id,x,y,z\n1,2,3,4\n"),
        ("w.vip", "WSPOT 1 6.0 1 2 3 4 5\n"),
        ("w.xml", WELD),
    ):
        points = [read_joint_bytes(Path(name), m + text.encode()).points for m in (b"", MARK)]
        assert len(points[0]) == 1 and np.array_equal(*points)


WELD = """<xml_connection_file><version>1.0</version><connection_group id="1">
<connected_to><part><pid>1</pid></part></connected_to><connection_list>
<connection_0d><spotweld/><loc>1 2 3</loc></connection_0d></connection_list>
</connection_group></xml_connection_file>"""
