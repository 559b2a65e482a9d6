# SPDX-License-Identifier: LGPL-2.1-or-later
"""A deck: its nodes in the basic system, and its files with moved nodes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import BinaryIO

import numpy as np

from ..base.arrays import Bools, Floats, Ints
from ..base.blocks import CHUNK, chunks
from ..base.errors import FileError, InputError, list_ids
from .frames import Frame, FrameError, Frames
from .model import BINARY, FIXED, PADDED, Block, Elements, Raw, table_of
from .numbers import format_reals, last_digit, parse_real
from .text import Edit, write_edited
from .wide import is_small_grid, wide_grid

_EIGHT = 8
# Largest number of element nodes to check when a deck is read. Elements of the second list can
# refer to scalar points, which have no position.
_MOST_CHECKED = 2_000_000
_SCALAR = ("CELAS", "CDAMP", "CMASS", "MPC", "*EQUATION")


class Deck:
    """The files of a deck with their content.

    path is the first file and texts has all of them. ids (n,) are the nodes in file order, and
    points (n, 3) their positions in the basic system. frames has the coordinate systems by number.
    notes are remarks for the user.
    """

    def __init__(self, raw: Raw, frames: dict[int, Frame] | None = None):
        self.raw = raw
        self.path: Path = raw.texts[0].path
        self.texts = raw.texts
        self.elements: list[Elements] = raw.elements
        self.frames = frames or {}
        table = table_of(raw)
        self.ids, self._values, self._systems = table.ids, table.values, table.systems
        self._files, self._lines, self._rows = table.files, table.lines, table.rows
        self._order: Ints | None = None
        self.points = self._basic()
        self._note_missing_nodes()
        self.notes = [*raw.notes, *raw.cut]

    def _note_missing_nodes(self) -> None:
        """Record elements with missing nodes; for shells sheet_of() raises an error."""
        if sum(block.nodes.size for block in self.elements) > _MOST_CHECKED:
            return
        for block in self.elements:
            if block.kind != "shell" and not block.name.startswith(_SCALAR):
                error = missing_nodes(self, block)
                if error is not None:
                    self.raw.miss(block.file, error.what, (error.line or 1) - 1)

    @property
    def form(self) -> str:
        """Name of the format."""
        return self.raw.form

    def find(self, ids: Ints) -> Ints:
        """Return the indices of nodes with these ids, -1 where there is none."""
        if self._order is None:
            kind = np.int32 if len(self.ids) < 2**31 else np.int64
            self._order = np.argsort(self.ids, kind="stable").astype(kind)
        if not len(self.ids):
            return np.full(np.shape(ids), -1)
        ordered = self.ids[self._order]
        at = np.minimum(np.searchsorted(ordered, ids), len(ordered) - 1)
        return np.where(ordered[at] == ids, self._order[at], -1)

    def place_of(self, node: int) -> tuple[int, int]:
        """Return file and line, from 0, of the node with an index."""
        return int(self._files[node]), int(self._lines[node])

    def width_of(self, nodes: Ints) -> int:
        """Return the smallest field width among these nodes (indices), in characters."""
        wanted = np.zeros(len(self.ids), dtype=bool)
        wanted[nodes] = True
        rooms = [
            block.room
            for block, rows in zip(self.raw.blocks, self._rows)
            if wanted[rows[rows >= 0]].any()
        ]
        return min(rooms, default=0)

    def digit(self, nodes: Ints, points: Floats) -> float:
        """Return the last digit, mm, that the file stores for coordinates (k, 3) of nodes (k,).

        It is at least that of a double.
        """
        size, width = float(np.abs(points).max(initial=0.0)), self.width_of(nodes)
        if not self._systems[nodes].any():
            return last_digit(size, width)
        # Angles are in degrees; their last digit moves a node by its distance from the axis.
        return last_digit(max(size, 360.0), width) * max(1.0, float(np.radians(size)))

    def _basic(self) -> Floats:
        if not self._systems.any():
            return self._values
        points, numbers = self._values.copy(), np.unique(self._systems)
        frames = Frames(self.frames, self._locate_at_rest)
        # A system can be defined by nodes in another system, so each is computed on demand.
        self._frames_at_rest = frames
        for number in numbers[numbers != 0].tolist():
            rows = np.flatnonzero(self._systems == number)
            points[rows] = self._told(rows[0], lambda: frames.to_basic(number, self._values[rows]))
        return points

    def _told(self, row: int, work: Callable[[], Floats]) -> Floats:
        try:
            return work()
        except FrameError as error:
            raise self._refused(row, error) from None

    def _refused(self, row: int, error: InputError) -> FileError:
        return self.raw.error(self.place_of(row), f"node {self.ids[row]}: {error.what}", error.todo)

    def _locate_at_rest(self, node: int) -> Floats:
        row = self._row_of(node)
        value = self._values[row : row + 1]
        found: Floats = self._frames_at_rest.to_basic(int(self._systems[row]), value)[0]
        return found

    def _row_of(self, node: int) -> int:
        row = int(self.find(np.array([node]))[0])
        if row < 0:
            raise FrameError(
                0, f"a coordinate system is defined by node {node}, which does not exist"
            )
        return row

    def save(self, positions: Floats, file: int, out: BinaryIO, *, is_wide: bool = False) -> None:
        """Write one of the files with the nodes at positions (n, 3).

        With is_wide, moved nodes in small Nastran fields get large fields. Raises FileError for a
        number that does not fit its field.
        """
        values = self._written_values(positions)
        edits = self._wide_edits(file, values) if is_wide else self._edits(file, values)
        write_edited(self.texts[file], out, edits)

    def _wide_edits(self, file: int, values: Floats) -> Iterator[Edit]:
        """Return the edits with small GRID cards replaced by large ones, all at once."""
        text = self.texts[file]
        found: list[tuple[int, int, bytes]] = []
        for number, block in enumerate(self.raw.blocks):
            if block.file != file:
                continue
            may = self.form == "Nastran" and block.kind == FIXED and block.room == 8
            changed = self._changed(number, values, slice(None)).reshape(-1, 3).any(axis=1)
            moved = np.flatnonzero(changed).tolist() if may else []
            rows = [k for k in moved if is_small_grid(text, int(block.lines[k]))]
            for k in rows:
                node = int(self._rows[number][k])
                shown = self._texts(values[node], 16, node)
                found.append(wide_grid(text, int(block.lines[k]), shown))
            wide = {int(block.lines[k]) for k in rows}
            for at, widths, texts in self._edits_of([number], values):
                lines = np.searchsorted(text.begins, at, side="right") - 1
                found += [
                    (begin, width, new)
                    for begin, width, new, line in zip(
                        at.tolist(), widths.tolist(), texts, lines.tolist()
                    )
                    if line not in wide
                ]
        found.sort(key=lambda edit: edit[0])
        if found:
            begins, lengths, numbers = zip(*found)
            yield np.array(begins), np.array(lengths), list(numbers)

    def unwritten(self, positions: Floats) -> Ints:
        """Return the nodes (k,) that moved to positions (n, 3) but cannot be written."""
        locked = self.find(np.array(sorted(self.raw.locked), dtype=np.int64))
        locked = locked[locked >= 0]
        found: Ints = locked[(positions[locked] != self.points[locked]).any(axis=1)]
        return found

    def _written_values(self, positions: Floats) -> Floats:
        """Return the numbers (n, 3) for the file; unmoved nodes keep theirs."""
        moved = (positions != self.points).any(axis=1)
        values = np.where(moved[:, None], positions, self._values)
        if not self._systems.any():
            return values
        frames, numbers = self._moved_frames(positions), np.unique(self._systems)
        for number in numbers[numbers != 0].tolist():
            rows = np.flatnonzero(self._systems == number)
            is_still = self._stays(number, frames)
            rows = rows[moved[rows]] if is_still else rows
            near = self._values[rows]
            values[rows] = frames.from_basic(number, positions[rows], near)
        return values

    def _stays(self, number: int, frames: Frames) -> bool:
        before, after = self._frames_at_rest.axes(number), frames.axes(number)
        return all(np.array_equal(a, b) for a, b in zip(before, after))

    def _moved_frames(self, positions: Floats) -> Frames:
        """Return the coordinate systems that the written numbers of their nodes define."""

        def locate(node: int) -> Floats:
            row = self._row_of(node)
            number, place = int(self._systems[row]), positions[row : row + 1]
            found: Floats = self.points[row]
            if not np.array_equal(place[0], found) or number != 0:
                value = frames.from_basic(number, place, self._values[row : row + 1])[0]
                found = frames.to_basic(number, self._rounded(row, value)[None])[0]
            return found

        frames = Frames(self.frames, locate)
        return frames

    def _rounded(self, row: int, value: Floats) -> Floats:
        block = next(
            block for block, rows in zip(self.raw.blocks, self._rows) if (rows == row).any()
        )
        if block.kind == BINARY:
            return value
        texts = self._texts(value, block.room, row)
        return np.array([parse_real(text) for text in texts])

    def _texts(self, values: Floats, room: int, row: int) -> list[str]:
        try:
            return format_reals(values, room, self.raw.mark)
        except InputError as error:
            raise self._refused(row, error) from None

    def _edits(self, file: int, values: Floats) -> Iterator[Edit]:
        """Yield the changed pieces of a file in order."""
        blocks = enumerate(self.raw.blocks)
        mine = [k for k, block in blocks if block.file == file and len(block.ids)]
        mine.sort(key=lambda k: int(self.raw.blocks[k].begins[0, 0]))
        if all(map(self._is_rising, mine)) and self._are_apart(mine):
            for k in mine:
                yield from self._edits_of([k], values)
        else:
            # Blocks of one file can be interleaved (odd cards among plain ones).
            yield from self._edits_of(mine, values)

    def _is_rising(self, number: int) -> bool:
        begins = self.raw.blocks[number].begins.reshape(-1)
        return all(
            bool(
                (
                    begins[at + 1 : at + CHUNK + 1]
                    >= begins[at : at + CHUNK][: len(begins) - at - 1]
                ).all()
            )
            for at in range(0, len(begins) - 1, CHUNK)
        )

    def _are_apart(self, numbers: list[int]) -> bool:
        """Return whether ascending blocks follow each other without overlap."""
        blocks = [self.raw.blocks[k] for k in numbers]
        ends = [int(block.begins[-1, -1]) for block in blocks]
        return all(end <= int(b.begins[0, 0]) for end, b in zip(ends, blocks[1:]))

    def _edits_of(self, numbers: list[int], values: Floats) -> Iterator[Edit]:
        """Yield the changed pieces of some blocks in order."""
        if not numbers:
            return
        if len(numbers) == 1 and self._is_rising(numbers[0]):
            block = self.raw.blocks[numbers[0]]
            for part in chunks(len(block.ids)):
                index = np.flatnonzero(self._changed(numbers[0], values, part)) + 3 * part.start
                at = block.begins.reshape(-1)[index]
                owner = np.full(len(index), numbers[0])
                yield at, *self._pieces(owner, index, values)
            return
        blocks = [self.raw.blocks[k] for k in numbers]
        at = np.concatenate([block.begins.reshape(-1) for block in blocks])
        owner = np.repeat(numbers, [3 * len(block.ids) for block in blocks])
        index = np.concatenate([np.arange(3 * len(block.ids)) for block in blocks])
        is_new = np.concatenate([self._changed(k, values, slice(None)) for k in numbers])
        order = np.flatnonzero(is_new)
        order = order[np.argsort(at[order], kind="stable")]
        for begin in range(0, len(order), CHUNK):
            rows = order[begin : begin + CHUNK]
            yield at[rows], *self._pieces(owner[rows], index[rows], values)

    def _changed(self, number: int, values: Floats, part: slice) -> Bools:
        """Return which numbers (3 k,) of some rows of a block must be written."""
        block, rows = self.raw.blocks[number], self._rows[number][part]
        new = values[np.maximum(rows, 0)]
        changed = (new != block.values[part]) & (rows >= 0)[:, None]
        # If a line is too short for its fields, all of them are written.
        short = (block.widths[part] < (block.room if block.kind == FIXED else 0)).any(axis=1)
        first, last, _ = part.indices(len(block.ids))
        for line, _ in block.leads:
            if first <= line < last:
                short[line - first] = True
        changed |= (changed.any(axis=1) & short)[:, None]
        found: Bools = changed.reshape(-1)
        return found

    def _pieces(self, owner: Ints, index: Ints, values: Floats) -> tuple[Ints, list[bytes]]:
        widths = np.zeros(len(owner), dtype=np.int64)
        texts: list[bytes] = [b""] * len(owner)
        for number in np.unique(owner).tolist():
            where = np.flatnonzero(owner == number)
            block, rows = self.raw.blocks[number], self._rows[number]
            line, axis = np.divmod(index[where], 3)
            widths[where] = block.widths[line, axis]
            new = values[rows[line], axis]
            shown = self._shown(block, new, rows[line])
            for k, text in zip(where.tolist(), self._fitted(block, line, axis, shown)):
                texts[k] = text
        return widths, texts

    def _shown(self, block: Block, new: Floats, rows: Ints) -> list[bytes]:
        if block.kind == BINARY:
            raw = new.astype("<f8").tobytes()
            return [raw[k : k + _EIGHT] for k in range(0, len(raw), _EIGHT)]
        try:
            return [text.encode() for text in format_reals(new, block.room, self.raw.mark)]
        except InputError:
            for row, value in zip(rows.tolist(), new):
                # raises for the number that does not fit
                self._texts(np.array([value]), block.room, row)
            raise

    def _fitted(self, block: Block, line: Ints, axis: Ints, shown: list[bytes]) -> Iterator[bytes]:
        """Yield the numbers with the blanks that keep all other fields in their columns."""
        if block.kind == PADDED:
            for row, k, text in zip(line.tolist(), axis.tolist(), shown):
                yield b" " * block.leads.get((row, k), 0) + text.ljust(block.room)
            return
        if block.kind != FIXED:
            for row, k, text in zip(line.tolist(), axis.tolist(), shown):
                yield b"," * block.leads.get((row, k), 0) + text if block.leads else text
            return
        data, room = self.texts[block.file].data, block.room
        begins, widths = block.begins[line, axis].tolist(), block.widths[line, axis].tolist()
        for k, text in enumerate(shown):
            width = widths[k]
            old = data[begins[k] : begins[k] + width]
            if width < room:
                lead = block.leads.get((int(line[k]), int(axis[k])), 0)
                end = data[begins[k] + width : begins[k] + width + 1]
                is_last = axis[k] == 2 and end in (b"", b"\n", b"\r")
                yield b" " * lead + (text if is_last else text.ljust(room))
            elif old[-1:] != b" " or not old.strip():
                yield text.rjust(room)
            else:
                lead = min(len(old) - len(old.lstrip()), room - len(text))
                yield (b" " * lead + text).ljust(room)


def missing_nodes(deck: Deck, elements: Elements) -> FileError | None:
    """Return the error for the first element with nodes that the deck does not have."""
    wanted = elements.nodes
    lost = (deck.find(wanted) < 0) & (wanted != 0)
    rows = np.flatnonzero(lost.any(axis=1))
    if not len(rows):
        return None
    row = int(rows[0])
    text = deck.texts[elements.file]
    what = f"{elements.name} {elements.ids[row]} names nodes that do not exist: "
    what += list_ids(wanted[row][lost[row]].tolist())
    return text.error(int(elements.lines[row]), what, "add the nodes, or the file that has them")
