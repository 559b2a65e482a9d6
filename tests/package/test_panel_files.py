# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widgets of the panels explain themselves and need no particular size or colour."""

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

PANELS = sorted((Path(__file__).parents[2] / "resources" / "panels").glob("*.ui"))
SILENT = ("QWidget", "QLabel", "QGroupBox", "QFrame", "QDialog", "Line", "QScrollArea")
FILLED_BY_CODE = {"guide": r"[A-Z]\w+"}  # buttons of commands: the code gives them the tool tip


def widgets(path: Path):
    """Class, name and properties of every widget in a file."""
    for widget in ET.parse(path).getroot().iter("widget"):
        named = {p.get("name"): p for p in widget.findall("property")}
        yield widget.get("class"), widget.get("name"), named


@pytest.mark.parametrize("path", PANELS, ids=lambda path: path.stem)
def test_every_widget_that_is_used_says_what_it_does(path):
    by_code = FILLED_BY_CODE.get(path.stem, "(?!)")
    silent = [
        name
        for kind, name, properties in widgets(path)
        if kind not in SILENT and "toolTip" not in properties and not re.fullmatch(by_code, name)
    ]
    assert silent == []


@pytest.mark.parametrize("path", PANELS, ids=lambda path: path.stem)
def test_no_colour_is_fixed_so_that_dark_themes_work(path):
    text = path.read_text("utf-8")
    assert "background" not in text and "<palette" not in text
    colours = re.findall(r"color:[^;\"]*", text)
    assert colours == []


def test_there_are_panels():
    assert len(PANELS) >= 8
