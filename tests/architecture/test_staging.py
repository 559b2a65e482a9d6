# SPDX-License-Identifier: LGPL-2.1-or-later
"""The staged add-on is always what a fresh one would be."""
import importlib.util

import pytest
from source_tree import ROOT


@pytest.fixture(scope="module")
def staging():
    spec = importlib.util.spec_from_file_location("stage", ROOT / "Mod" / "stage.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def source(tmp_path):
    """A small repository with one file in each place."""
    python = "bindings/python/sheetmorph/b.py"
    for name in ("Mod/SheetMorph/freecad/a.py", python, "resources/c.svg"):
        path = tmp_path / "source" / name
        path.parent.mkdir(parents=True)
        path.write_text(name)
    (tmp_path / "source" / "LICENSE").write_text("free")
    return tmp_path / "source"


def staged_files(staged):
    return sorted(path.relative_to(staged).as_posix() for path in staged.rglob("*.*"))


def test_the_manual_is_staged_if_it_is_built(staging, tmp_path):
    source, staged = tmp_path / "source", tmp_path / "build" / "Mod" / "SheetMorph"
    source.mkdir()
    page = tmp_path / "build" / "docs" / "html" / "command" / "One.html"
    page.parent.mkdir(parents=True)
    page.write_text("one")
    staging.stage(source, staged, [])
    assert not (staged / "manual").exists()
    (page.parents[1] / "index.html").write_text("start")
    staging.stage(source, staged, [])
    assert (staged / "manual" / "command" / "One.html").read_text() == "one"


def test_everything_comes_to_its_place(staging, source, tmp_path):
    module = tmp_path / "_core.so"
    module.write_text("machine code")
    words = tmp_path / "SheetMorph_de.qm"
    words.write_text("Wörter")
    staging.stage(source, tmp_path / "staged", [module, words])
    assert staged_files(tmp_path / "staged") == [
        "freecad/a.py",
        "resources/c.svg",
        "resources/translations/SheetMorph_de.qm",
        "sheetmorph/_core.so",
        "sheetmorph/b.py",
    ]
    assert (tmp_path / "staged" / "LICENSE").read_text() == "free"


def test_changed_files_are_copied_and_others_left_alone(staging, source, tmp_path):
    staged = tmp_path / "staged"
    staging.stage(source, staged, [])
    before = (staged / "resources/c.svg").stat().st_ino
    (source / "Mod/SheetMorph/freecad/a.py").write_text("changed")
    staging.stage(source, staged, [])
    assert (staged / "freecad/a.py").read_text() == "changed"
    assert (staged / "resources/c.svg").stat().st_ino == before


def test_vanished_files_and_their_folders_are_removed(staging, source, tmp_path):
    staged = tmp_path / "staged"
    staging.stage(source, staged, [])
    cache = staged / "freecad" / "__pycache__"
    cache.mkdir()
    (cache / "a.cpython-311.pyc").write_text("compiled")
    staging.stage(source, staged, [])
    assert (cache / "a.cpython-311.pyc").is_file()
    (source / "Mod/SheetMorph/freecad/a.py").unlink()
    staging.stage(source, staged, [])
    assert not (staged / "freecad").exists()
