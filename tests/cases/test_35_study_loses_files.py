# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study into a folder that holds things of the user, or a variant that lost a file."""
from collections.abc import Callable
from pathlib import Path

from conftest import sheetmorph


def test_a_folder_of_the_user_is_refused(case: Callable[[str], Path]) -> None:
    folder = case("35")
    mine = folder / "one" / "000001"
    mine.mkdir(parents=True)
    (mine / "parameters.json").write_text('{"mine": 1}')
    (mine / "thesis.txt").write_text("precious")
    done = sheetmorph("study", "study.json", "-o", "one", "--quiet", folder=folder)
    assert done.status == 2 and "000001" in done.err and "thesis.txt" in done.err
    assert (mine / "thesis.txt").read_text() == "precious"


def test_a_note_in_a_variant_is_not_lost_with_it(case: Callable[[str], Path]) -> None:
    folder = case("35")
    study = folder / "study.json"
    assert sheetmorph("study", "study.json", "-o", "two", "--quiet", folder=folder).status == 0
    note = folder / "two" / "000001" / "thesis.txt"
    note.write_text("precious")
    study.write_text(study.read_text().replace('"seed": 1', '"seed": 2'))
    done = sheetmorph("study", "study.json", "-o", "two", "--quiet", folder=folder)
    assert done.status == 2 and "thesis.txt" in done.err
    assert note.read_text() == "precious"


def test_what_is_damaged_is_computed_again(case: Callable[[str], Path]) -> None:
    folder = case("35")
    assert sheetmorph("study", "study.json", "-o", "three", "--quiet", folder=folder).status == 0
    mesh, certificate = (
        folder / "three" / name for name in ("000001/a.obj", "000003/certificate.json")
    )
    before = mesh.read_bytes(), certificate.read_bytes()
    mesh.write_bytes(b"")
    certificate.unlink()
    done = sheetmorph("study", "study.json", "-o", "three", "--quiet", folder=folder)
    assert done.status == 0 and "2 computed" in done.out
    assert (mesh.read_bytes(), certificate.read_bytes()) == before
