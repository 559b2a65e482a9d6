# SPDX-License-Identifier: LGPL-2.1-or-later
"""`./sheetmorph docs` builds a manual without faults that needs no network."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from manual_pages import DOCUMENTS, ROOT, Page, broken_links, pages_below

import sheetmorph
from sheetmorph.cli import parser

SECONDS = 3600.0  # on a machine that does much else
SETTINGS = ROOT / "resources" / "packaging" / "manual"
OF_THE_NETWORK = re.compile(r"""(@import|url\()\s*["']?(https?:)?//""")


@pytest.fixture(scope="module")
def manual() -> Path:
    """The built manual; the command installs nothing here, it names what is missing."""
    done = subprocess.run(
        [str(ROOT / "sheetmorph"), "docs"],
        env={**os.environ, "SHEETMORPH_NO_APT": "1"},
        capture_output=True,
        text=True,
        timeout=SECONDS,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return ROOT / "build" / "docs" / "html"


@pytest.fixture(scope="module")
def pages(manual: Path) -> dict[Path, Page]:
    """The pages of the manual."""
    return pages_below(manual)


def words_of(page: Path) -> str:
    """The text of a page, without tags."""
    text = re.sub(r"<[^>]+>", "", page.read_text("utf-8"))
    return text.replace("&quot;", '"').replace("&#39;", "'").replace("&lt;", "<")


def test_every_source_is_a_page_that_the_start_page_leads_to(manual: Path, pages):
    start = manual / "index.html"
    led_to = {(start.parent / link.split("#")[0]).resolve() for link in pages[start].links}
    sources = [path.relative_to(DOCUMENTS) for path in DOCUMENTS.rglob("*.md")]
    assert len(sources) > 20
    built = {path: (manual / path).with_suffix(".html") for path in sources}
    assert [str(path) for path, page in built.items() if page not in led_to] == ["index.md"]


def test_every_link_leads_somewhere(pages):
    assert broken_links(pages) == []


def test_no_page_loads_anything_from_the_network(manual: Path, pages):
    loaded = [one for page in pages.values() for one in page.loaded]
    assert len(loaded) > len(pages)
    assert [one for one in loaded if re.match(r"(https?:)?//", one)] == []
    styles = [path.read_text("utf-8") for path in manual.rglob("*.css")]
    assert styles and not any(OF_THE_NETWORK.search(style) for style in styles)


def test_every_page_follows_the_colours_of_the_system(pages):
    """Furo of Debian 12 has its dark colours only behind a button that does not work."""
    for page in pages.values():
        text = page.path.read_text("utf-8")
        dark = text[text.find("(prefers-color-scheme: dark)") :].split("</style>")[0]
        assert "--color-background-primary: #131416" in dark
        assert any(name.split("?")[0].endswith("manual.js") for name in page.loaded)


def test_the_search_knows_every_page(manual: Path):
    index = (manual / "searchindex.js").read_text("utf-8")
    names = json.loads(re.search(r'"?docnames"?:\s*(\[.*?\])', index).group(1))
    sources = [path.relative_to(DOCUMENTS).with_suffix("") for path in DOCUMENTS.rglob("*.md")]
    assert sorted(names) == sorted(path.as_posix() for path in sources)


def test_the_page_of_the_command_line_lists_every_option(manual: Path):
    text = words_of(manual / "reference" / "command-line.html")
    (commands,) = [action for action in parser()._actions if action.dest == "command"]
    options = {
        option
        for one in commands.choices.values()
        for action in one._actions
        for option in action.option_strings
    }
    assert len(options) > 20
    assert [name for name in [*commands.choices, *options] if name not in text] == []


def test_the_page_of_commands_lists_every_command_of_the_workbench(manual: Path):
    text = words_of(manual / "reference" / "commands.html")
    table = read(ROOT / "Mod/SheetMorph/freecad/sheetmorph/commands/table.py")
    named = re.findall(r'^        "(SheetMorph_\w+)",$', table, re.M)
    assert len(named) > 30
    assert [name for name in named if name not in text] == []


def test_every_command_of_the_workbench_has_its_page(manual: Path):
    text = words_of(manual / "reference" / "commands.html")
    named = set(re.findall(r"\bSheetMorph_\w+", text))
    assert len(named) > 30
    for name in named:
        page = words_of(manual / "command" / f"{name}.html")
        assert "How to use it" in page and "All commands" in page


def read(path: Path) -> str:
    """The text of a file."""
    return path.read_text("utf-8")


@pytest.mark.parametrize(
    ("page", "name"),
    [("recipe-keys", "recipe"), ("study-keys", "study")]
    + [(name, name) for name in ("report", "certificate", "doctor", "find")],
)
def test_a_page_of_keys_lists_every_key_of_its_schema(manual: Path, page, name):
    text = words_of(manual / "reference" / f"{page}.html")
    (schema,) = Path(sheetmorph.__file__).parent.rglob(f"{name}.schema.json")
    keys = keys_in(json.loads(schema.read_text("utf-8")))
    assert len(keys) > 20
    assert [key for key in sorted(keys) if not re.search(rf"^{re.escape(key)}\b", text, re.M)] == []


def keys_in(entry: object) -> set[str]:
    """The names of all properties below an entry of a schema; bare `{}` only repeat another."""
    if isinstance(entry, list):
        return set().union(*map(keys_in, entry))
    if not isinstance(entry, dict):
        return set()
    own = entry.get("properties", {})
    named = {key for key, value in own.items() if value} if isinstance(own, dict) else set()
    return named.union(*(keys_in(value) for value in entry.values()))


def test_a_broken_link_and_a_page_without_a_way_to_it_are_errors(tmp_path: Path):
    (tmp_path / "index.md").write_text("# One\n\n[a](gone.md) [b](other.md#nowhere)\n")
    (tmp_path / "other.md").write_text("# Other\n")
    done = subprocess.run(
        [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html"]
        + ["-c", str(SETTINGS), str(tmp_path), str(tmp_path / "html")],
        capture_output=True,
        text=True,
        timeout=SECONDS,
        check=False,
    )
    assert done.returncode != 0
    for fault in ("gone.md", "nowhere", "other.md: WARNING: document isn't included"):
        assert fault in done.stderr


def test_a_link_to_nothing_is_noticed(tmp_path: Path):
    (tmp_path / "a.html").write_text('<a href="b.html#x">1</a><a href="c.html">2</a>')
    (tmp_path / "b.html").write_text('<p id="y"><img src="d.png"><a href="a.html">3</a></p>')
    found = broken_links(pages_below(tmp_path))
    assert found == ["a.html: b.html#x", "a.html: c.html", "b.html: d.png"]
