# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points with part ids in lines: VIP files, and tables with a header line."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .points import Joint, JointFile

# WSPOT, id, diameter, x, y, z, parts.
_VIP = re.compile(rb"\s*WSPOT", re.IGNORECASE)
_VIP_ID, _VIP_X, _VIP_PARTS = 1, 3, 6
_COMMENTS = (b"#", b"$", b"//")
_QUOTED = rb'\s*"(?:[^"]|"")*"\s*'
_UNITS = {"": 1.0, "mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "inch": 25.4}
_IDS = {"id", "no", "nr", "number", "label", "name", "weldid", "pointid", "jointid", "boltid"}
_KINDS = {"type", "kind", "weldtype", "jointtype", "config"}
_PART = re.compile(r"(connected)?(part|pid|link|panel|sheet|component|layer)(id|name)?\d*")
_AXIS = re.compile(r"(?:([xyz])|([xyz])(?:pos|coord)\w*|(?:pos|coord)\w*([xyz]))")


@dataclass(frozen=True)
class _Line:
    """A line: its number from 0, and the byte ranges of its fields."""

    number: int
    fields: list[tuple[int, int]]


def read_vip(path: Path, data: bytes) -> JointFile:
    """Read the spot welds of a VIP file. Raises FileError."""
    file = JointFile(path, data, "VIP")
    others = 0
    for number, begin, end in _lines(data):
        raw = data[begin:end]
        if not _VIP.match(raw):
            others += bool(raw.strip()) and not raw.lstrip().startswith(_COMMENTS)
            continue
        if b"," in raw:
            fields = _fields(data, begin, end, b",")
        else:
            fields = [(begin + m.start(), begin + m.end()) for m in re.finditer(rb"\S+", raw)]
        if len(fields) < _VIP_PARTS:
            what = "WSPOT needs an id, a diameter and three coordinates"
            raise file.error(number, what)
        line = _Line(number, fields)
        joint = Joint(_shown(data, fields[_VIP_ID]), _shown(data, fields[0]), number)
        joint.parts = _parts(data, fields[_VIP_PARTS:])
        _add(file, joint, line, [_VIP_X, _VIP_X + 1, _VIP_X + 2])
    if others:
        file.notes.append(f"{others} lines other than WSPOT stay unchanged")
    if not file.joints:
        raise file.error(None, "no line begins with WSPOT", "check what file it is")
    return file


def read_csv(path: Path, data: bytes) -> JointFile:
    """Read the points of a table. Raises FileError."""
    file = JointFile(path, data, "CSV")
    rows = _rows(file)
    head = next(rows, None)
    if head is None:
        raise file.error(None, "it is empty", "export it again")
    axes, others = _columns(file, head)
    count = len(head.fields)
    needed = 1 + max(*axes, *(others.get(key, 0) for key in ("id", "kind")))
    for line in rows:
        if len(line.fields) < needed:
            raise file.error(line.number, f"{len(line.fields)} columns, the first line has {count}")
        name = _shown(data, line.fields[others["id"]]) if "id" in others else str(line.number + 1)
        kind = _shown(data, line.fields[others["kind"]]) if "kind" in others else ""
        joint = Joint(name, kind, line.number)
        # Extra columns beyond the header belong to its last part column.
        wanted = [k for k in others["parts"] if k < len(line.fields)]
        wanted += range(count, len(line.fields)) if others["parts"] else []
        joint.parts = _parts(data, [line.fields[k] for k in wanted])
        _add(file, joint, line, axes)
    return file


def _lines(data: bytes) -> Iterator[tuple[int, int, int]]:
    begin = 3 if data.startswith(b"\xef\xbb\xbf") else 0
    for number, found in enumerate(re.finditer(rb"([^\r\n]*)(\r\n|\n|\r|$)", data[begin:])):
        if found.end() > found.start():
            yield number, begin + found.start(1), begin + found.end(1)


def _rows(file: JointFile) -> Iterator[_Line]:
    """Yield the non-empty lines; the first one determines the separator."""
    separator = None
    for number, begin, end in _lines(file.data):
        raw = file.data[begin:end]
        if not raw.strip() or raw.lstrip().startswith(_COMMENTS):
            continue
        if separator is None:
            separator = next((s for s in (b";", b"\t", b",") if s in raw), b",")
            rest = file.data[end:]
            if separator != b"," and re.search(rb"\d,\d", rest) and not re.search(rb"\d\.\d", rest):
                file.comma = b","
        yield _Line(number, _fields(file.data, begin, end, separator))


def _fields(data: bytes, begin: int, end: int, separator: bytes) -> list[tuple[int, int]]:
    """Return the byte ranges of the fields of a line, without quotation marks."""
    rule = re.compile(rb"(%s|[^%s]*)(%s|$)" % (_QUOTED, separator, separator))
    # For text after a closing quotation mark.
    plain = re.compile(rb"([^%s]*)(%s|$)" % (separator, separator))
    found, at = [], begin
    raw = data[begin:end]
    place = 0
    while True:
        match = rule.match(raw, place) or plain.match(raw, place)
        assert match is not None  # the pattern also matches an empty field or an empty rest
        first, last = match.span(1)
        inner = raw[first:last]
        if re.fullmatch(_QUOTED, inner):
            first += inner.index(b'"') + 1
            last = match.start(1) + inner.rindex(b'"')
        found.append((at + first, at + last))
        place = match.end()
        if not match.group(2):
            return found


def _columns(file: JointFile, head: _Line) -> tuple[list[int], dict[str, Any]]:
    """Return the columns of x, y and z, and those of other data."""
    axes: dict[str, int] = {}
    others: dict[str, Any] = {"parts": []}
    units = set()
    for k, field in enumerate(head.fields):
        shown = _shown(file.data, field).lower()
        plain, unit = _name_and_unit(shown)
        name = re.sub(r"[^a-z0-9]", "", plain)
        axis = _AXIS.fullmatch(name)
        if axis:
            axes.setdefault(next(filter(None, axis.groups())), k)
            units.add(unit)
        elif _PART.fullmatch(name):
            others["parts"].append(k)
        elif name in _IDS:
            others.setdefault("id", k)
        elif name in _KINDS:
            others.setdefault("kind", k)
    if set(axes) != set("xyz"):
        todo = "name the columns, for example id,x,y,z,part1,part2"
        raise file.error(head.number, "its first line does not name columns x, y and z", todo)
    if len(units) > 1 or not units <= set(_UNITS):
        what = f"columns in {', '.join(sorted(units))}"
        raise file.error(head.number, what, "give x, y and z in mm")
    file.unit = _UNITS[units.pop()]
    return [axes[axis] for axis in "xyz"], others


def _name_and_unit(shown: str) -> tuple[str, str]:
    """Split "x [mm]" into "x" and "mm"."""
    found = re.search(r"[\[(]([^\])]*)[\])]", shown)
    return (shown[: found.start()], found.group(1).strip()) if found else (shown, "")


def _shown(data: bytes, field: tuple[int, int]) -> str:
    return data[field[0] : field[1]].decode("utf-8", "replace").strip()


def _parts(data: bytes, fields: list[tuple[int, int]]) -> list[tuple[str, ...]]:
    return [(name,) for name in (_shown(data, field) for field in fields) if name]


def _add(file: JointFile, joint: Joint, line: _Line, axes: list[int]) -> None:
    shown = f"{file.form} {joint.name}".strip()
    numbers = [file.number(*line.fields[k], line.number, shown) for k in axes]
    file.joints.append(joint)
    file.add_point(joint, numbers)
