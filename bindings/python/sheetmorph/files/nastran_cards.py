# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bulk data lines as cards of fields: small and large fixed fields, and free (comma) fields."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple


class Field(NamedTuple):
    """A field's text and its place: line index, columns begin .. begin + width.

    width 0: free form; -1: free form, left out at the end of its line.
    """

    text: str
    line: int
    begin: int
    width: int


@dataclass
class Card:
    """name without the `*`; line: index of its first line; fields: all behind the name, in order.

    is_large: 16 characters a field.
    """

    name: str
    line: int
    is_large: bool
    fields: list[Field]

    def text(self, position: int) -> str:
        """Stripped text of the field at a position (0: behind the name), "" if left out."""
        return self.fields[position].text.strip() if position < len(self.fields) else ""


def bulk_range(lines: list[str]) -> tuple[int, int]:
    """First line and the line behind the last one of the bulk data; a file without BEGIN is all."""
    first = 0
    for number, line in enumerate(lines):
        words = line.split("$", 1)[0].upper().split()
        if words[:1] == ["BEGIN"] and (len(words) == 1 or "BULK" in words[1]):
            first = number + 1
            break
    for number in range(first, len(lines)):
        if lines[number][:7].upper() == "ENDDATA":
            return first, number
    return first, len(lines)


def cards(lines: list[str], names: frozenset[str]) -> Iterator[Card]:
    """The cards with these names in the bulk data, with their continuation lines."""
    first, end = bulk_range(lines)
    card: Card | None = None
    for number in range(first, end):
        body = _body(lines[number])
        if not body.strip():
            continue
        if _is_continuation(body):
            if card is not None:
                card.fields += _fields(body, number, is_large=body.startswith("*"))
            continue
        if card is not None:
            yield card
        name = _name(body)
        card = _open(name, body, number) if name.rstrip("*") in names else None
    if card is not None:
        yield card


def _body(line: str) -> str:
    body = line.split("$", 1)[0].rstrip("\r\n")
    return body.expandtabs(8) if "\t" in body else body


def _is_continuation(body: str) -> bool:
    head = (body.split(",", 1)[0] if "," in body[:10] else body[:8]).strip()
    return not head or head[0] in "+*"


def _name(body: str) -> str:
    head = body.split(",", 1)[0] if "," in body[:10] else body[:8]
    return head.strip().upper()


def _open(name: str, body: str, number: int) -> Card:
    is_large = name.endswith("*")
    return Card(name.rstrip("*"), number, is_large, _fields(body, number, is_large))


def _fields(body: str, number: int, is_large: bool) -> list[Field]:
    """The data fields of one line: 8 of a small one, 4 of a large one; blank ones included."""
    count = 4 if is_large else 8
    if "," in body[:10]:
        return _free_fields(body, number, count)
    width = 16 if is_large else 8
    places = [8 + k * width for k in range(count)]
    return [Field(body[at : at + width], number, at, width) for at in places]


def _free_fields(body: str, number: int, count: int) -> list[Field]:
    fields = []
    at = body.index(",") + 1
    for text in body.split(",")[1 : count + 1]:
        fields.append(Field(text, number, at, 0))
        at += len(text) + 1
    end = len(body)
    fields += [Field("", number, end, -1) for _ in range(count - len(fields))]
    return fields


def replaced(line: str, edits: list[tuple[Field, str]]) -> str:
    """A line with the text of some of its fields exchanged; all else as it was."""
    content = line.rstrip("\r\n")
    ending = line[len(content) :]
    has_tabs = "\t" in content.split("$", 1)[0]
    content = content.expandtabs(8) if has_tabs else content
    # From the last field to the first, so that the columns of those still to come stay right.
    for field, text in reversed(sorted(edits, key=lambda edit: edit[0].begin)):
        if field.width > 0:
            content = _fixed_edit(content, field, text)
        else:
            end = field.begin + len(field.text)
            comma = "," if field.width < 0 else ""
            content = content[: field.begin] + comma + text + content[end:]
    return content + ending


def _fixed_edit(content: str, field: Field, text: str) -> str:
    # A line may end, or a comment begin, before the field is full.
    body = content.split("$", 1)[0]
    comment = content[len(body) :]
    end = field.begin + field.width
    behind = body[end:]
    padded = text.ljust(field.width) if behind or comment else text
    return body[: field.begin].ljust(field.begin) + padded + behind + comment
