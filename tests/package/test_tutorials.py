# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tutorials and how-to guides do what they say: their code blocks run, from top to bottom."""

from __future__ import annotations

import re
import shlex
import shutil
from pathlib import Path

import pytest
from manual_pages import DOCUMENTS, ROOT, Block, code_blocks

from sheetmorph.cli import main

FOLDERS = ("tutorials", "how-to")
PAGES = sorted(path for folder in FOLDERS for path in (DOCUMENTS / folder).glob("*.md"))
EXAMPLE = re.compile(r"`(resources/examples/[\w./-]+)`")


def prepare(page: Path, folder: Path) -> None:
    """Copy the files of the examples that a page names into a folder."""
    for name in EXAMPLE.findall(page.read_text("utf-8")):
        source = ROOT / name
        if source.is_dir():
            shutil.copytree(source, folder, dirs_exist_ok=True)
        else:
            shutil.copy(source, folder)


def run_line(line: str) -> None:
    """Run one line of a shell block: a command of SheetMorph, or one of the entry script."""
    words = shlex.split(line, comments=True)
    if not words:
        return
    if words[0] == "./sheetmorph":
        commands = re.findall(r"^  (\w+) ", (ROOT / "sheetmorph").read_text(), re.MULTILINE)
        assert words[1] in commands, line
        return
    assert words[0] == "sheetmorph", line
    assert main(words[1:]) == 0, line


def run_block(block: Block, names: dict[str, object]) -> None:
    """Write the file of a block, or run it."""
    if block.file:
        Path(block.file).write_text(block.text, "utf-8")
    elif block.language == "python":
        exec(compile(block.text, "page", "exec"), names)
    else:
        assert block.language == "sh", f"nothing runs a block of {block.language}"
        for line in block.text.splitlines():
            run_line(line)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_code_of_a_page_runs(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    prepare(page, tmp_path)
    names: dict[str, object] = {}
    blocks = code_blocks(page)
    assert blocks or "![" in page.read_text("utf-8")  # a page about the window has pictures
    for block in blocks:
        run_block(block, names)
    promised = re.findall(r"^- `([\w./-]+)`: ", page.read_text("utf-8"), re.MULTILINE)
    assert [name for name in promised if not (tmp_path / name).exists()] == []


def test_blocks_are_read_from_a_page(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(
        "```{code-block} json\n:caption: a.json\n\n{}\n```\n\n"
        "````{admonition} B\nc\n````\n\n```sh\nsheetmorph --version\n```\n"
    )
    recipe, command = Block("json", "{}\n", "a.json"), Block("sh", "sheetmorph --version\n", "")
    assert code_blocks(page) == [recipe, command]


@pytest.mark.parametrize("line", ["rm -rf x", "./sheetmorph fly", "sheetmorph run none.json -o x"])
def test_a_line_that_cannot_run_is_noticed(line):
    with pytest.raises(AssertionError):
        run_line(line)
