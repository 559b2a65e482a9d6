# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every public deck with shells is bent by 5 % of its size: only coordinates change."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import pytest

from bent_decks import CALCULIX, SHARED, all_decks, bent, with_stand_ins

# What is refused, as people read it.
REASONS = {
    r"names nodes that do not exist": "shells whose nodes are in other files",
    r"fewer than three nodes": "shells whose nodes are parameters",
    r"a deck of several models is not read": "several models in one deck",
    r"is defined twice, differently": "defined twice, differently",
    r"is not a whole number|^CBUSH:": "a field that is no number",
    r"moves nodes after they are read": "nodes that move after they are read",
}
# With an empty file for each include that is missing.
COUNTS = {
    "nastran": {
        "bent": 65, "no shells": 51, "shells whose nodes are in other files": 9,
        "several models in one deck": 4, "defined twice, differently": 1,
        "a field that is no number": 1, "its nodes are in one place": 1,
    },
    "ls-dyna": {"bent": 11, "no shells": 6, "shells whose nodes are parameters": 1},
    "radioss": {"bent": 10, "no shells": 17, "nodes that move after they are read": 1},
    "calculix": {"bent": 23, "no shells": 332},
}  # fmt: skip


def outcome(path: Path, folder: Path) -> str:
    """What bending a deck ends with, in the words of the table."""
    told = bent(path, folder)
    if not told.startswith("refused"):
        return told
    found = [name for rule, name in REASONS.items() if re.search(rule, told[9:])]
    assert found, f"{path.name}: {told}"
    return found[0]


@pytest.mark.parametrize("form", sorted(COUNTS))
def test_every_deck_is_bent_or_refused_in_words(form: str, tmp_path: Path):
    if not (CALCULIX if form == "calculix" else SHARED).is_dir():
        pytest.skip("the decks are not here")
    (tmp_path / "unpacked").mkdir()
    found: Counter[str] = Counter()
    for number, (name, path) in enumerate(all_decks(tmp_path / "unpacked")):
        if name != form:
            continue
        folder = tmp_path / str(number)
        folder.mkdir()
        place = path if name == "calculix" else with_stand_ins(path, folder)
        found[outcome(place, folder)] += 1
    print(f"NOTE {form}: " + ", ".join(f"{count} {what}" for what, count in found.items()))
    assert found == COUNTS[form]
