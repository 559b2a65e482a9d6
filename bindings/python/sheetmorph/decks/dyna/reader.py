# SPDX-License-Identifier: LGPL-2.1-or-later
"""LS-DYNA keyword files: nodes, elements and joints, in all three field widths."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

import numpy as np

from ..cut import Cut
from ..deck import Deck
from ..includes import Included
from ..model import FREE, WORD, Block, Opener, Raw
from ..numbers import parse_integer, parse_real
from ..placing import note_placing, remember_placing
from .cards import DynaCards, Section
from .elements import ELEMENTS, add_elements
from .joints import JOINTS, Joints
from .stale import stale_of
from .table import CARDS, LONG, NODE, STANDARD, TEN, Widths

SUFFIXES = (".k", ".key", ".dyn", ".keyword")
# Keywords in the form of nodes, and whether they define nodes of the model.
_NODES = {
    "NODE": True,
    "AIRBAG_REFERENCE_GEOMETRY": False,
    "AIRBAG_REFERENCE_GEOMETRY_RDT": False,
    "INITIAL_FOAM_REFERENCE_GEOMETRY": False,
    "BOUNDARY_PRESCRIBED_FINAL_GEOMETRY": False,
}
# Materials that start with id, density, Young's modulus, Poisson's ratio.
_MATERIALS = frozenset(
    f"MAT_{name}"
    for names in (
        "ELASTIC 001 PLASTIC_KINEMATIC 003 POWER_LAW_PLASTICITY 018 RIGID 020",
        "STRAIN_RATE_DEPENDENT_PLASTICITY 019 PIECEWISE_LINEAR_PLASTICITY 024",
        "3-PARAMETER_BARLAT 036 TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC 037",
        "SIMPLIFIED_JOHNSON_COOK 098 MODIFIED_PIECEWISE_LINEAR_PLASTICITY 123",
    )
    for name in names.split()
)


def read_dyna(path: Path, opener: Opener) -> Deck:
    """Read a keyword deck with its includes. Raises FileError."""
    reader = _Reader(Raw("LS-DYNA"), path, opener)
    return reader.read()


# Line, id, values, and for each coordinate its text, begin and width.
_OddNode = tuple[int, int, list[float], list[tuple[str, int, int]]]


# Options that apply as if every *KEYWORD had them; solvers also accept them as arguments.
_assumed: ContextVar[str] = ContextVar("assumed", default="")


@contextmanager
def assumed_options(options: str) -> Iterator[None]:
    """Read decks as if their *KEYWORD had these options, "long=y" or "i10=y"."""
    token = _assumed.set(options)
    try:
        yield
    finally:
        _assumed.reset(token)


class _Reader:
    """The state of the reader."""

    def __init__(self, raw: Raw, path: Path, opener: Opener):
        self.raw = raw
        self._path = path
        self._included = Included(raw, path, opener)
        self._widths = STANDARD
        self._take_options(_assumed.get())
        self._parameters: dict[str, float] = {}
        self._joints = Joints(raw)
        self._parts: dict[int, int] = {}
        self._sections: dict[int, float] = {}
        self._ended = False
        self._is_whole = False

    def read(self) -> Deck:
        self._file(self._included.first(self._path))
        if not self._is_whole:
            self.raw.miss(0, "there is no *END: the end of the file may be missing")
        self._joints.finish()
        for part, section in self._parts.items():
            if self._sections.get(section):
                self.raw.thickness[part] = self._sections[section]
        return Deck(self.raw)

    def _file(self, file: int) -> None:
        text = self.raw.texts[file]
        self._included.enter(file)
        cards = DynaCards(self.raw, file)
        outer = self._widths
        for section in cards.sections():
            if self._ended:
                break
            self._section(cards, section)
        if len(text) and not cards.has_keywords:
            raise self.raw.error((file, 0), "there is no *KEYWORD", "check what kind of file it is")
        self._widths = outer
        self._ended = False
        self._included.leave()

    def _section(self, cards: DynaCards, section: Section) -> None:
        """Read a keyword with its cards."""
        name = section.name
        widths = {"%": TEN, "+": LONG, "-": STANDARD}.get(section.suffix, self._widths)
        cards.parameters, cards.width = self._parameters, widths.other
        if name == "END":
            self._ended = True
            self._is_whole = self._is_whole or cards.file == 0
        elif name == "KEYWORD":
            self._keyword(section)
        elif name.startswith("INCLUDE"):
            self._include(cards, section)
        elif name.startswith("PARAMETER"):
            self._parameter(cards, section)
        elif name in _NODES:
            self._nodes(cards, section, widths)
        elif note_placing(self.raw, name, (cards.file, section.line)):
            pass
        elif name.startswith(ELEMENTS):
            add_elements(cards, section, widths.label, widths.real)
        elif name.startswith(JOINTS):
            self._joints.add(cards, section)
        elif name.removesuffix("_TITLE") in _MATERIALS:
            self._material(cards, section)
        elif name in ("PART", "SECTION_SHELL", "SECTION_SHELL_TITLE"):
            self._properties(cards, section)
        self.raw.stale += stale_of(cards, section)

    def _keyword(self, section: Section) -> None:
        self._take_options(section.rest.lower())

    def _take_options(self, options: str) -> None:
        if kind := re.search(r"long\s*=\s*(y|s|k)", options):
            self._widths = STANDARD if kind.group(1) == "s" else LONG
        if re.search(r"i10\s*=\s*y", options):
            self._widths = TEN

    def _include(self, cards: DynaCards, section: Section) -> None:
        names = cards.names(section)
        option = section.name[len("INCLUDE") :]
        if option.startswith("_PATH"):
            for _, name in names:
                self._included.add_folder(name)
            return
        if option.startswith("_TRANSFORM"):
            names = names[:1]
            if not _is_plain(cards, section):
                remember_placing(self.raw, section.name, (cards.file, section.line))
        elif option:
            what = f"*{section.name}: its included file is not read and stays unchanged"
            self.raw.notes.append(f"{cards.text.name}, line {section.line + 1}: {what}")
            return
        for line, name in names:
            file = self._included.add(name, (cards.file, line))
            self._file(file)

    def _parameter(self, cards: DynaCards, section: Section) -> None:
        if section.name not in ("PARAMETER", "PARAMETER_LOCAL"):
            return
        for line in section.rows.tolist():
            fields = cards.fields(line, cards.width)
            for name, value in zip(fields[::2], fields[1::2]):
                words = name.split()
                key = words[-1] if len(words) > 1 else name.strip()[1:]
                number = parse_real(value)
                if key and value.strip() and number is not None:
                    self._parameters[key.lower()] = number

    def _nodes(self, cards: DynaCards, section: Section, widths: Widths) -> None:
        is_model = _NODES[section.name]
        rows = cards.filled(section.rows)
        if section.name == "AIRBAG_REFERENCE_GEOMETRY_RDT":
            rows = rows[1:]
        plain = cards.plain(rows)
        blocks = []
        if plain.any():
            cut = Cut(self.raw, cards.file, rows[plain], cards.stops, f"*{section.name}")
            blocks.append(cut.nodes(widths.label * NODE["point"].at, widths.real))
        odd = [self._odd_node(cards, line, widths) for line in rows[~plain].tolist()]
        blocks += _joined(cards.file, [one for one in odd if one], widths.real)
        if is_model:
            self.raw.blocks += blocks

    def _odd_node(self, cards: DynaCards, line: int, widths: Widths) -> _OddNode | None:
        """Return a node in free fields or with parameters."""
        fields = cards.places(line, [widths.label] + [widths.real] * 3)
        number = parse_integer(cards.value(fields[0][0]))
        if number is None:
            what = f'*NODE: "{fields[0][0].strip()}" is not a whole number'
            raise self.raw.error((cards.file, line), what)
        values = []
        for shown, _, _ in fields[1:4]:
            value = parse_real(cards.value(shown))
            if value is None:
                what = f'node {number}: "{shown.strip()}" is not a known number'
                raise self.raw.error((cards.file, line), what, "give the parameter a number")
            values.append(value)
            if "&" in shown:
                self.raw.locked[number] = f"{shown.strip()} is a parameter"
        return line, number, values, fields[1:4]

    def _material(self, cards: DynaCards, section: Section) -> None:
        rows = section.rows.tolist()[1 if section.name.endswith("_TITLE") else 0 :]
        if not rows:
            return
        fields, layout = cards.fields(rows[0], cards.width), CARDS["MAT"]
        found, key = self.raw.materials, fields[layout["id"].at].strip()
        for name in ("density", "young", "poisson"):
            getattr(found, name)[key] = parse_real(fields[layout[name].at]) or 0.0
        found.names[key] = f"*{section.name} {key}"

    def _properties(self, cards: DynaCards, section: Section) -> None:
        rows = section.rows.tolist()
        if section.name == "PART":
            layout = CARDS["PART"]
            for title, line in zip(rows[::2], rows[1::2]):
                fields = cards.fields(line, cards.width)
                number = parse_integer(fields[layout["id"].at]) or 0
                self._parts[number] = parse_integer(fields[layout["section"].at]) or 0
                self.raw.names[number] = cards.text.line(title).strip()
                material = fields[layout["material"].at].strip()
                self.raw.materials.of_property[number] = material
            return
        layout, titles = CARDS["SECTION_SHELL"], int(section.name.endswith("TITLE"))
        at = titles
        while at + layout["thickness"].card < len(rows):
            fields = cards.fields(rows[at], cards.width)
            number = parse_integer(fields[layout["id"].at]) or 0
            second = cards.fields(rows[at + layout["thickness"].card], cards.width)
            self._sections[number] = parse_real(second[layout["thickness"].at]) or 0.0
            # Angles of a layered shell, one per integration point, eight per card.
            is_layered = parse_integer(fields[layout["angles"].at]) == 1
            points = int(parse_real(fields[layout["points"].at]) or 0.0)
            at += 2 + titles + (-(-points // 8) if is_layered else 0)


def _is_plain(cards: DynaCards, section: Section) -> bool:
    """Return whether an include is not shifted, rotated, scaled or renumbered.

    The first two cards have id offsets, the third has factors of mass, time and length, and the
    last a transformation.
    """
    rows = section.rows.tolist()
    named = set(cards.filled(section.rows).tolist())
    while rows and (rows[0] not in named or cards.text.line(rows[0]).rstrip().endswith(" +")):
        rows = rows[1:]
    # Blank cards count, and they shift nothing.
    for k, line in enumerate(rows[1:]):
        fields = [text.strip() for text in cards.fields(line, cards.width)]
        # The other fields are a name prefix and suffix, or the temperature scale, which do not
        # affect positions.
        fields = fields[:1] if k in (1, 3) else fields[:3] if k == 2 else fields
        allowed = (0.0, 1.0) if k == 2 else (0.0,)
        if any(text and parse_real(text) not in allowed for text in fields):
            return False
    return True


def _joined(file: int, rows: list[_OddNode], room: int) -> list[Block]:
    if not rows:
        return []
    lines, ids, values, fields = zip(*rows)
    begins = np.array([[begin for _, begin, _ in three] for three in fields])
    widths = np.array([[width for _, _, width in three] for three in fields], np.uint8)
    leads = {}
    for row, three in enumerate(fields):
        for axis, (_, _, width) in enumerate(three):
            if not width and len(three) > axis and three[axis][1] < 0:
                leads[row, axis] = 1
    begins = np.abs(begins)
    kind = FREE if leads else WORD
    return [
        Block(
            file, np.array(lines, np.int32), np.array(ids), np.array(values), begins, widths,
            room, kind, None, leads,
        )
    ]  # fmt: skip
