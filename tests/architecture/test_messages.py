# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nobody reads in a message what a fault says as such: whom it concerns, where, what to do."""
import ast

import pytest
from messages import bare_errors, formatted_faults, reading_faults
from source_tree import ROOT, faults_in, files

PACKAGE = ROOT / "bindings" / "python"
WORKBENCH = ROOT / "Mod"
FOREIGN = {
    "bindings/python/sheetmorph/recipe/reading.py",  # tomllib tells line and column in words alone
}
EDGES = {
    "bindings/python/sheetmorph/certifying/page.py": "the page of a certificate",
    "bindings/python/sheetmorph/cli/entry.py": "the command line",
    "bindings/python/sheetmorph/morph/morph.py": "a morph in a notebook",
    "bindings/python/sheetmorph/pictures/notebook.py": "a picture in a notebook",
    "bindings/python/sheetmorph/starting/installation.py": "the report of doctor",
    "bindings/python/sheetmorph/study/pictures.py": "the page of a study",
    "Mod/SheetMorph/freecad/sheetmorph/bridge/kernel.py": "the report of Check Installation",
    "Mod/SheetMorph/freecad/sheetmorph/commands/installation.py": "the report view of FreeCAD",
    "Mod/SheetMorph/freecad/sheetmorph/init_gui.py": "the report view of FreeCAD",
    "Mod/SheetMorph/freecad/sheetmorph/scene/drawing.py": "why the compiled module does not load",
}
"""Modules that make the text of an error, and where the user sees it."""
OWN = {"_Lost", "_Stopped", "Forgotten"}
"""Exceptions of the package that never leave the module that raises them."""


def sources():
    found = [*files(".py", below=PACKAGE), *files(".py", below=WORKBENCH)]
    return [p for p in found if "tests" not in p.parts and str(p.relative_to(ROOT)) not in FOREIGN]


def test_messages_are_written_and_never_read():
    assert faults_in(sources(), lambda path: reading_faults(path.read_text())) == {}


def package_sources():
    return [path for path in sources() if PACKAGE in path.parents and path.parent != PACKAGE]


def errors_of_the_package():
    """The bases of all exception classes of the package, by name."""
    trees = (ast.parse(path.read_text()) for path in package_sources())
    classes = [node for tree in trees for node in ast.walk(tree) if isinstance(node, ast.ClassDef)]
    found = {node.name: {getattr(base, "id", "") for base in node.bases} for node in classes}
    roots = {"Exception", "ValueError", "RuntimeError", "SheetMorphError"}
    while grown := {n for n, bases in found.items() if bases & roots} - roots:
        roots |= grown
    return {name: found[name] for name in roots if name in found}


def test_every_error_of_the_package_has_faults():
    errors = errors_of_the_package()
    assert {"RecipeError", "FileError", "NotFlat", "Question", "CertificateError"} <= set(errors)
    known = {"SheetMorphError"}
    while more := {n for n, bases in errors.items() if bases & known} - known:
        known |= more
    assert set(errors) - known == OWN
    assert faults_in(package_sources(), lambda path: bare_errors(path.read_text())) == {}


def test_the_text_of_an_error_is_made_at_the_edge():
    names = {*errors_of_the_package(), "InvalidInput", "SolverError", "FAULTS", "FAILURES"}

    def found(path):
        return formatted_faults(path.read_text(), names)

    places = faults_in(sources(), found)
    assert set(places) <= set(EDGES), places


def test_an_error_that_is_formatted_or_has_no_fault_is_noticed():
    handler = "try:\n    f()\nexcept (FileError, OSError) as error:\n    "
    for use in ("say(str(error))\n", "say(f'no: {error}')\n"):
        assert len(formatted_faults(handler + use, {"FileError"})) == 1
        assert formatted_faults(handler + use, {"RecipeError"}) == []
    assert formatted_faults(handler + "say(error.what)\n", {"FileError"}) == []
    assert len(bare_errors("raise ValueError('no')\n")) == 1
    assert bare_errors("raise FileError(path, what, todo)\n") == []


@pytest.mark.parametrize(
    "text",
    [
        "rigid = [text for text in failures if text not in failed]\n",
        "what, _, todo = sentence.rpartition('; ')\n",
        "if why.startswith('flipped'):\n    pass\n",
        "try:\n    f()\nexcept ValueError as error:\n    a, b = str(error).split('; ')\n",
        "try:\n    f()\nexcept ValueError as e:\n    text = str(e)\n    re.match('x', text)\n",
        "try:\n    f()\nexcept ValueError as e:\n    if 'vertex' in str(e):\n        pass\n",
        "found = [m for m in warning.splitlines()]\n",
    ],
)
def test_a_message_that_is_read_is_noticed(text):
    assert len(reading_faults(text)) == 1


@pytest.mark.parametrize(
    "text",
    [
        "try:\n    f()\nexcept ValueError as e:\n    t = ' '.join(str(e).split())\n",
        "name.split('/')\n",
        "if label in labels:\n    pass\n",
    ],
)
def test_what_is_no_message_is_left_alone(text):
    assert reading_faults(text) == []
