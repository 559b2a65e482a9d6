# SPDX-License-Identifier: LGPL-2.1-or-later
"""Input files of Abaqus and CalculiX: *NODE with commas, with or without parts and instances."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from ...base.arrays import Bools, Floats, Ints
from ...base.blocks import chunks
from ...base.errors import FileError
from ..commas import comma_nodes, comma_places, integers
from ..cut import small
from ..deck import Deck
from ..frames import Frame
from ..includes import Included
from ..model import Elements, Opener, Place, Raw
from ..placing import note_placing
from .joints import Sets, add_joint
from .lines import AbaqusLines, Keyword
from .sets import NamedSets
from .table import FIELDS, SECTIONS, element_type

SUFFIXES = (".inp",)
# CalculiX reads at most this number of characters.
_ROOM = 20
_BLOCKS = ("PART", "ASSEMBLY", "INSTANCE", "STEP")
_FILLED = frozenset(
    ("NODE", "ELEMENT", *SECTIONS, "NSET", "ELSET", "ORIENTATION", "ELASTIC", "DENSITY", "NGEN")
    + ("MPC", "EQUATION", "KINEMATIC COUPLING")
)
_MADE = ("NGEN", "NFILL")
_STALE = {
    "ORIENTATION": "local directions by coordinates stay unchanged",
    "NODAL THICKNESS": "the thickness at its nodes stays unchanged",
    "NORMAL": "normals by components stay unchanged",
    "TRANSFORM": "local directions by coordinates stay unchanged",
    "INITIAL CONDITIONS": "an initial state of the undeformed shape",
    "TIE": "the solver may shift tied nodes onto the other surface when it starts (ADJUST)",
    "IMPERFECTION": "an imperfection of the undeformed shape",
    "MASS FLOW": "",
    "ROTARY INERTIA": "its inertia stays unchanged",
    "DISTRIBUTION": "a mapped field stays unchanged",
}


def read_abaqus(path: Path, opener: Opener) -> Deck:
    """Read an input file with its includes. Raises FileError."""
    return _Reader(Raw("Abaqus", wins="last"), path, opener).read()


@dataclass(frozen=True)
class _Section:
    """A shell section: the number of its part, the name of its set, and its values."""

    part: int
    name: str
    thickness: float
    material: str
    place: tuple[int, int]


@dataclass
class _Part:
    """A part: its name, how often it is placed, and its node blocks and elements in the deck."""

    name: str
    number: int
    placed: int = 0
    frame: Frame | None = None
    blocks: list[int] = field(default_factory=list)
    elements: list[int] = field(default_factory=list)


class _Reader:
    """The state of the reader."""

    def __init__(self, raw: Raw, path: Path, opener: Opener):
        self.raw = raw
        self._path = path
        self._included = Included(raw, path, opener)
        self._parts: list[_Part] = []
        self._part: _Part | None = None
        self._model = _Part("", 0)
        self._frames: dict[int, Frame] = {}
        self._system = 0
        self._sets = Sets(raw)
        self._names = NamedSets()
        self._instances: dict[str, _Part] = {}
        self._elsets: dict[tuple[int, str], int] = {}
        self._sections: list[_Section] = []
        self._material_name = ""
        self._open_blocks: dict[str, tuple[int, int]] = {}

    def read(self) -> Deck:
        self._file(self._included.first(self._path))
        for name, (file, line) in self._open_blocks.items():
            self.raw.miss(file, f"*{name} has no *END {name}: the end may be missing", line)
        for part in self._parts:
            if part.blocks and not part.placed:
                file = self.raw.blocks[part.blocks[0]].file
                self.raw.miss(file, f"no *INSTANCE uses the part {part.name}")
        self._sets.finish()
        owners = self._number_parts()
        self._names.finish(self.raw, owners, self._give_sections())
        frames = dict(self._frames)
        for part in self._parts:
            if part.frame is not None:
                frames[part.number] = part.frame
            elif part.number not in frames:
                frames[part.number] = _frame(np.eye(3), np.zeros(3), 0)
        return Deck(self.raw, frames)

    def _file(self, file: int) -> None:
        self._included.enter(file)
        lines = AbaqusLines(self.raw, file)
        for keyword in lines.keywords():
            self._keyword(lines, keyword)
        if not lines.has_keywords and file == 0:
            raise self.raw.error((file, 0), "there is no keyword (*)", "check what file it is")
        self._included.leave()

    def _keyword(self, lines: AbaqusLines, keyword: Keyword) -> None:
        name = keyword.name
        if name in _BLOCKS:
            self._open_blocks[name] = (lines.file, keyword.line)
        self._open_blocks.pop(name.removeprefix("END "), None) if name[:4] == "END " else None
        if name in _FILLED and not len(keyword.rows) and not keyword.options.get("INPUT"):
            self.raw.miss(lines.file, f"*{name} has no lines", keyword.line)
        if name == "INCLUDE":
            name_of = keyword.options.get("INPUT", "")
            self._file(self._included.add(name_of, (lines.file, keyword.line)))
        elif name == "NODE":
            self._nodes(lines, keyword)
        elif name == "ELEMENT":
            self._elements(lines, keyword)
        elif name == "SYSTEM":
            self._system = self._define(lines, keyword)
        elif name in _MADE:
            place = f"{lines.text.name}, line {keyword.line + 1}"
            told = f"{place}: *{name} generates nodes; they are not written and follow"
            self.raw.notes.append(f"{told} only as the solver generates them")
        elif note_placing(self.raw, name, (lines.file, keyword.line)):
            pass
        elif name in ("PART", "END PART", "INSTANCE", "END INSTANCE"):
            self._scope(lines, keyword)
        elif name in SECTIONS and len(keyword.rows):
            self._section(lines, keyword)
        elif name in ("MATERIAL", "ELASTIC", "DENSITY"):
            self._material(lines, keyword)
        else:
            if name in ("NSET", "ELSET"):
                instance = keyword.options.get("INSTANCE", "").upper()
                owner = self._instances.get(instance, self._owner())
                self._names.read(lines, keyword, owner.number)
            add_joint(self._sets, lines, keyword)
        is_left = name == "TIE" and keyword.options.get("ADJUST", "").upper() == "NO"
        if _STALE.get(name) and not is_left:
            self.raw.stale.append(Place(f"*{name}", 0, lines.file, keyword.line, _STALE[name]))

    def _section(self, lines: AbaqusLines, keyword: Keyword) -> None:
        options = keyword.options
        line, first, end = FIELDS["SHELL SECTION"]["thickness"]
        is_layered = "COMPOSITE" in options
        rows = keyword.rows if is_layered else keyword.rows[line : line + 1]
        layers = [lines.reals(int(row))[first:end] for row in rows]
        thickness = sum(value or 0.0 for layer in layers for value in layer)
        material = options.get("MATERIAL", "").upper()
        name, place = options.get("ELSET", ""), (lines.file, keyword.line)
        self._sections.append(_Section(self._owner().number, name, thickness, material, place))

    def _give_sections(self) -> dict[int, tuple[list[int], Ints]]:
        """Assign the number of its section to every element.

        Sections can take elements from numbers that *ELEMENT assigned. For each such number the
        result has the blocks and ids of all its original elements.
        """
        before: dict[int, tuple[list[int], Ints]] = {}
        blocks_of = {part.number: part.elements for part in [self._model, *self._parts]}
        elements = self.raw.elements
        for section in self._sections:
            key = (section.part, section.name.upper())
            own = self._elsets.get(key)
            number = len(self._elsets) + 1 if own is None else own
            ids, numbers = self._names.elements_of(*key)
            numbers = [one for one in numbers if one != own]
            count = 0
            for k in blocks_of[section.part] if len(ids) or numbers else ():
                old = elements[k]
                inside = np.isin(old.ids, ids) | np.isin(old.properties, numbers)
                inside &= old.properties != number
                for lost in np.unique(old.properties[inside]).tolist():
                    same = [
                        j for j in blocks_of[section.part] if (elements[j].properties == lost).any()
                    ]
                    found = [elements[j].ids[elements[j].properties == lost] for j in same]
                    before.setdefault(lost, (same, np.concatenate(found)))
                if inside.any():
                    count += int(inside.sum())
                    properties = np.where(inside, np.int32(number), old.properties)
                    elements[k] = replace(old, properties=properties)
            if own is None and not count:
                what = f'a section is given to the ELSET "{section.name}", which has no elements'
                self.raw.miss(section.place[0], what, section.place[1])
                continue
            self._elsets[key] = number
            self.raw.thickness[number] = section.thickness
            self.raw.names[number] = section.name
            self.raw.materials.of_property[number] = section.material
        return before

    def _material(self, lines: AbaqusLines, keyword: Keyword) -> None:
        found = self.raw.materials
        if keyword.name == "MATERIAL":
            self._material_name = keyword.options.get("NAME", "").upper()
            found.names[self._material_name] = f"*MATERIAL {self._material_name}"
        elif len(keyword.rows):
            is_elastic = keyword.name == "ELASTIC"
            if is_elastic and keyword.options.get("TYPE", "ISOTROPIC").upper()[:3] != "ISO":
                return
            for table, (line, first, end) in FIELDS[keyword.name].items():
                values = lines.reals(int(keyword.rows[line]))[first:end]
                getattr(found, table).update({self._material_name: v or 0.0 for v in values})

    def _scope(self, lines: AbaqusLines, keyword: Keyword) -> None:
        name = keyword.options.get("NAME", "").upper()
        if keyword.name == "PART":
            self._part = _Part(name, -(len(self._parts) + 1))
            self._parts.append(self._part)
        elif keyword.name == "INSTANCE":
            wanted = keyword.options.get("PART", "").upper()
            part = next((part for part in self._parts if part.name == wanted), None)
            if part is None:
                what = f'*INSTANCE {name}: there is no part "{wanted}"'
                raise self.raw.error((lines.file, keyword.line), what)
            part.placed += 1
            part.frame = self._placed(lines, keyword) if part.placed == 1 else part.frame
            self._part = self._instances[name] = part
        else:
            self._part = None
        self._system = 0

    def _placed(self, lines: AbaqusLines, keyword: Keyword) -> Frame:
        """Return the placement of an instance: a shift, then a rotation about an axis."""
        rows = [lines.reals(int(line)) for line in keyword.rows[:2]]
        for line, values in zip(keyword.rows.tolist(), rows):
            if None in values:
                what = "*INSTANCE: a value is not a number"
                raise self.raw.error((lines.file, line), what)
        at, first, end = FIELDS["INSTANCE"]["shift"]
        shift = np.array(([*rows[at], 0, 0, 0] if rows else [0, 0, 0])[first:end], dtype=float)
        if len(rows) < 2:
            return _frame(np.eye(3), shift, 0)
        told = np.array([*rows[FIELDS["INSTANCE"]["axis"][0]], *[0.0] * 7][:7], dtype=float)
        start, axis = told[:3], told[3:6] - told[:3]
        if not np.linalg.norm(axis) > 0.0:
            line = int(keyword.rows[1])
            raise self.raw.error((lines.file, line), "*INSTANCE: the axis has no length")
        turn = _turn(axis / np.linalg.norm(axis), np.radians(told[6]))
        return _frame(turn, start + turn @ (shift - start), 0)

    def _define(self, lines: AbaqusLines, keyword: Keyword) -> int:
        """Return the number of a new *SYSTEM."""
        rows = [lines.reals(int(line)) for line in keyword.rows[:2]]
        values = [value for row in rows for value in row]
        if not values:
            return 0
        if None in values or len(values) not in (3, 6, 9):
            raise self.raw.error((lines.file, keyword.line), "*SYSTEM needs one to three points")
        points = np.array(values, dtype=float).reshape(-1, 3)
        origin = points[0]
        x = points[1] - origin if len(points) > 1 else np.array([1.0, 0.0, 0.0])
        y = points[2] - origin if len(points) > 2 else np.cross([0.0, 0.0, 1.0], x)
        z = np.cross(x, y)
        outer = self._part.number if self._part else 0
        number = 1000 + len(self._frames)
        corners = np.array([origin, origin + z, origin + x])
        self._frames[number] = Frame("R", None, corners, outer)
        return number

    def _nodes(self, lines: AbaqusLines, keyword: Keyword) -> None:
        source, rows, file = lines, keyword.rows, lines.file
        if keyword.options.get("INPUT"):
            place = (lines.file, keyword.line)
            file = self._included.add(keyword.options["INPUT"], place)
            source = AbaqusLines(self.raw, file)
            rows = source.data_rows()
        if not len(rows):
            return
        del source
        block = comma_nodes(self.raw, file, rows, _ROOM)
        kind = keyword.options.get("SYSTEM", "R").upper()
        if kind == "S":
            what = "*NODE in spherical coordinates is not read"
            raise self.raw.error((lines.file, keyword.line), what, "write rectangular ones")
        outer = self._part.number if self._part else 0
        number = self._system or outer
        if kind == "C":
            number = 1000 + len(self._frames)
            unit = np.array([[0.0, 0, 0], [0, 0, 1], [1, 0, 0]])
            self._frames[number] = Frame("C", None, unit, self._system or outer)
        systems = np.full(len(block.ids), number, np.int32) if number else None
        self._owner().blocks.append(len(self.raw.blocks))
        self.raw.blocks.append(replace(block, systems=systems))
        name = keyword.options.get("NSET", "")
        self._sets.add_nodes(name, block.ids)
        self._names.add("NSET", name, self._owner().number, block.ids)

    def _owner(self) -> _Part:
        return self._part or self._model

    def _elements(self, lines: AbaqusLines, keyword: Keyword) -> None:
        source, rows = lines, keyword.rows
        if keyword.options.get("INPUT"):
            place = (lines.file, keyword.line)
            source = AbaqusLines(self.raw, self._included.add(keyword.options["INPUT"], place))
            rows = source.data_rows()
        if not len(rows):
            return
        name = keyword.options.get("TYPE", "").upper()
        kind, count = element_type(name)
        group = keyword.options.get("ELSET", "").upper()
        key = (self._owner().number, group)
        number = self._elsets.setdefault(key, len(self._elsets) + 1)
        self._names.add_section(group, number)
        self.raw.names[number] = keyword.options.get("ELSET", "")
        for heads, table in self._tables(source, rows, count):
            parts = np.broadcast_to(np.int32(number), len(heads))
            table = small(table) if table.dtype != np.int32 else table
            nodes = table[:, 1:]
            np.maximum(nodes, 0, out=nodes)
            self._owner().elements.append(len(self.raw.elements))
            self.raw.elements.append(
                Elements(
                    name or "*ELEMENT", kind, table[:, 0], parts,
                    nodes, source.file, heads.astype(np.int32, copy=False),
                )
            )  # fmt: skip

    def _tables(self, lines: AbaqusLines, rows: Ints, count: int) -> list[tuple[Ints, Ints]]:
        """Return the lines and integers (id, nodes) of elements."""
        text = lines.text
        if 0 < count <= 15:
            found: Ints = np.empty((len(rows), count + 1), dtype=np.int32)
            for part in chunks(len(rows)):
                begins, ends = comma_places(text, rows[part], count + 1)
                if (begins[:, -1] > text.ends[rows[part]]).any():
                    return self._loose(lines, rows, count)
                for k in range(count + 1):
                    values, sound = integers(text, begins[:, k], ends[:, k])
                    self._require(lines, rows[part], sound)
                    if found.dtype == np.int32 and small(values).dtype != np.int32:
                        found = found.astype(np.int64)
                    found[part, k] = values
            return [(rows, found)]
        return self._loose(lines, rows, count)

    def _require(self, lines: AbaqusLines, rows: Ints, sound: Bools) -> None:
        if not sound.all():
            raise self._no_number(lines, int(rows[np.flatnonzero(~sound)[0]]))

    def _no_number(self, lines: AbaqusLines, line: int) -> FileError:
        return self.raw.error((lines.file, line), "*ELEMENT: an entry is not a whole number")

    def _loose(self, lines: AbaqusLines, rows: Ints, count: int) -> list[tuple[Ints, Ints]]:
        """Return elements that span several lines; one continues until it has all nodes."""
        heads: list[int] = []
        found: list[list[int]] = []
        is_open = False
        for line in rows.tolist():
            numbers = lines.numbers(line)
            if numbers is None:
                raise self._no_number(lines, line)
            shown = lines.text.line(line).rstrip()
            if is_open:
                found[-1] += numbers
            else:
                heads.append(line)
                found.append(numbers)
            missing = len(found[-1]) <= count if count else shown.endswith(",")
            is_open = missing and (count > 0 or shown.endswith(","))
            if is_open and count and not shown.endswith(",") and len(numbers) < 16:
                is_open = False
        for head, numbers in zip(heads, found):
            if count and len(numbers) <= count:
                what = f"*ELEMENT {numbers[0]} has {len(numbers) - 1} of its {count} nodes"
                self.raw.miss(lines.file, what, head)
                break
        width = max(map(len, found), default=1)
        table = np.zeros((len(found), max(width, 2)), dtype=np.int64)
        for row, nodes in zip(table, found):
            row[: len(nodes)] = nodes
        return [(np.array(heads), table[:, : count + 1] if count else table)]

    def _number_parts(self) -> dict[int, tuple[list[int], int]]:
        """Renumber the nodes of several parts so that they are unique; a part placed twice cannot
        move.

        The result maps the number of a part to the blocks of its elements and the shift of its ids.
        """
        owners: dict[int, tuple[list[int], int]] = {}
        filled = [part for part in [self._model, *self._parts] if part.blocks]
        blocks = self.raw.blocks
        largest = max((int(b.ids.max(initial=0)) for b in blocks), default=0)
        step = 10 ** len(str(largest))
        for place, part in enumerate(filled):
            shift = place * step
            owners[part.number] = (part.elements, shift)
            for k in part.blocks:
                if shift:
                    blocks[k] = replace(blocks[k], ids=blocks[k].ids + shift)
                if part.placed > 1:
                    told = f"its part {part.name} has {part.placed} instances"
                    self.raw.locked |= dict.fromkeys(blocks[k].ids.tolist(), told)
            for k in part.elements if shift else ():
                old = self.raw.elements[k]
                nodes = old.nodes.astype(np.int64)
                self.raw.elements[k] = replace(old, nodes=np.where(nodes > 0, nodes + shift, 0))
            if shift:
                self.raw.notes.append(f"nodes of the part {part.name} count from {shift} on")
        return owners


def _frame(turn: Floats, origin: Floats, outer: int) -> Frame:
    corners = np.array([origin, origin + turn[:, 2], origin + turn[:, 0]])
    return Frame("R", None, corners, outer)


def _turn(axis: Floats, angle: float) -> Floats:
    """Return the rotation (3, 3) about a unit axis."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    found: Floats = np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross
    return found
