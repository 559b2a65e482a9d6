# SPDX-License-Identifier: LGPL-2.1-or-later
"""MCF and xMCF: connections of points, lines and faces in XML.

MCF 1.0 has ids and parts as elements, xMCF 3 (FAT 286, ISO/PAS 8329) as attributes.
"""

from __future__ import annotations

import re
from pathlib import Path
from xml.parsers import expat

from ..base.errors import FileError
from .points import Joint, JointFile, Number

_FORMS = {"xmcf": "xMCF", "xml_connection_file": "MCF"}
_UNITS = {"mm": 1.0, "cm": 10.0, "dm": 100.0, "m": 1000.0, "in": 25.4, "inch": 25.4, "ft": 304.8}
_CONNECTIONS = ("connection_0d", "connection_1d", "connection_2d")
_DIRECTIONS = ("normal_direction", "tangential_direction")
# Elements of a connection that do not give its kind.
_BESIDES = {"loc", "loc_list", "face_list", "appdata", "femdata", "info", "id", "type", "title"}
_BESIDES |= {"custom_attributes_list", "contact_list", *_DIRECTIONS}
_TAG = re.compile(rb"""<(?:[^"'<>]|"[^"]*"|'[^']*')*>""")
_TOKEN = re.compile(rb"[^\s,;]+")


def read_xml(path: Path, data: bytes) -> JointFile:
    """Read the connections of an MCF or xMCF file. Raises FileError."""
    return _Reader(JointFile(path, data, "xMCF")).read()


class _Reader:
    """The state of the parser."""

    def __init__(self, file: JointFile):
        self._file = file
        self._stack: list[str] = []
        self._parts: list[tuple[str, ...]] = []
        self._group: list[Joint] = []
        self._joint: Joint | None = None
        self._text: list[str] = []
        self._begin: int | None = None
        self._untold = 0
        self._parser = expat.ParserCreate()
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = self._end
        self._parser.CharacterDataHandler = self._characters
        self._parser.EntityDeclHandler = self._entity

    def read(self) -> JointFile:
        try:
            self._parser.Parse(self._file.data, True)
        except expat.ExpatError as error:
            what = f"not XML: {expat.ErrorString(error.code)}"
            raise self._file.error(error.lineno - 1, what) from None
        except (LookupError, ValueError) as error:
            if isinstance(error, FileError):
                raise
            what, todo = f"its encoding cannot be read ({error})", "save it as UTF-8"
            raise self._file.error(0, what, todo) from None
        if self._untold:
            told = f"{self._untold} directions of lines and faces stay unchanged"
            self._file.notes.append(told)
        return self._file

    @property
    def _line(self) -> int:
        return self._parser.CurrentLineNumber - 1

    def _error(self, what: str, todo: str = "correct the file") -> FileError:
        return self._file.error(self._line, what, todo)

    def _entity(self, *_told: object) -> None:
        raise self._error("it declares entities", "write out the values")

    def _start(self, tag: str, given: dict[str, str]) -> None:
        name = tag.rsplit(":", 1)[-1]
        if not self._stack:
            if name not in _FORMS:
                todo = "give a file whose first element is xmcf or xml_connection_file"
                raise self._error(f"<{name}> is neither MCF nor xMCF", todo)
            self._file.form = _FORMS[name]
        parent = self._stack[-1] if self._stack else ""
        self._stack.append(name)
        if len(self._stack) > 200:
            raise self._error("its elements are nested more than 200 deep")
        self._text, self._begin = [], None
        if name == "units":
            self._units(given.get("length", "mm"))
        elif name == "connection_group":
            self._parts, self._group = [], []
        elif parent == "connected_to" and given:
            names = (given.get(key, "").strip() for key in ("pid", "label", "name"))
            self._parts.append(tuple(one for one in names if one))
        elif name in _CONNECTIONS:
            label = given.get("label", given.get("id", ""))
            self._joint = Joint(label.strip(), "", self._line)
            self._group.append(self._joint)
            self._file.joints.append(self._joint)
        elif self._joint is not None and name in _DIRECTIONS:
            self._direction()
        elif self._joint is not None and parent in _CONNECTIONS and name not in _BESIDES:
            self._joint.kind = self._joint.kind or name

    def _units(self, length: str) -> None:
        unit = _UNITS.get(length.strip().lower())
        if unit is None:
            todo = f"give lengths in one of {', '.join(_UNITS)}"
            raise self._error(f'the unit of length "{length}" is not known', todo)
        self._file.unit = unit

    def _characters(self, text: str) -> None:
        if self._begin is None:
            self._begin = self._parser.CurrentByteIndex
        self._text.append(text)

    def _end(self, tag: str) -> None:
        name = self._stack.pop()
        parent = self._stack[-1] if self._stack else ""
        text = "".join(self._text).strip()
        joint = self._joint
        if name == "loc" and joint is not None:
            self._location(joint)
        elif name == "pid" and parent == "connected_to" and text:
            self._parts.append((text,))
        elif name in ("id", "label") and joint is not None and parent in _CONNECTIONS and text:
            joint.name = joint.name or text
        elif name == "type" and joint is not None and parent in _CONNECTIONS:
            joint.kind = text
        elif name in _CONNECTIONS:
            self._joint = None
        elif name == "connection_group":
            for one in self._group:
                one.parts = self._parts
        self._text, self._begin = [], None

    def _location(self, joint: Joint) -> None:
        begin, end = self._begin, self._parser.CurrentByteIndex
        raw = b"" if begin is None else self._file.data[begin:end]
        found = list(_TOKEN.finditer(raw))
        if begin is None or len(found) != 3 or b"<" in raw or b"&" in raw:
            raise self._error("<loc> needs three numbers and nothing else")
        self._file.add_point(
            joint, [self._number(begin + m.start(), begin + m.end(), "<loc>") for m in found]
        )

    def _number(self, begin: int, end: int, what: str) -> Number:
        return self._file.number(begin, end, self._line, what)

    def _direction(self) -> None:
        """Add a direction of a point; those of lines and faces stay unchanged."""
        assert self._joint is not None
        if "connection_0d" not in self._stack:
            self._untold += 1
            return
        begin = self._parser.CurrentByteIndex
        tag = _TAG.match(self._file.data, begin)
        numbers = []
        for axis in (b"x", b"y", b"z"):
            rule = rb"""\s%s\s*=\s*(?:"([^"]*)"|'([^']*)')""" % axis
            found = re.search(rule, tag.group()) if tag else None
            if not found:
                shown = self._stack[-1]
                raise self._error(f"<{shown}> has no {axis.decode()}")
            group = 1 if found.group(1) is not None else 2
            at = begin + found.start(group), begin + found.end(group)
            numbers.append(self._number(*at, f"<{self._stack[-1]}>"))
        self._file.add_direction(self._joint, numbers)
