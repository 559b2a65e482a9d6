# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layers see only what lies below them, and the checks notice when they do not."""
import pytest
from layers import MAY_INCLUDE, editing_faults, kernel_faults, package_faults, workbench_faults
from source_tree import BINDINGS, KERNEL, PACKAGE, WORKBENCH, faults_in, files, label


def test_a_kernel_source_includes_only_layers_below():
    sources = files(".h", ".cpp", below=KERNEL)
    assert {path.relative_to(KERNEL).parts[0] for path in sources} <= set(MAY_INCLUDE)
    assert faults_in(sources, lambda path: kernel_faults(layer_of(path), path.read_text())) == {}


def layer_of(path):
    return path.relative_to(KERNEL).parts[0]


def test_the_package_works_without_freecad():
    sources = files(".py", below=PACKAGE)
    assert sources
    assert faults_in(sources, lambda path: package_faults(path.read_text())) == {}


def test_a_workbench_source_keeps_to_its_place():
    sources = [path for path in files(".py", below=WORKBENCH) if place_of(path) != "tests"]
    assert sources
    assert faults_in(sources, lambda path: workbench_faults(place_of(path), path.read_text())) == {}


def test_only_the_editing_session_opens_steps_and_observes_documents():
    sources = [path for path in files(".py", below=WORKBENCH) if place_of(path) != "tests"]
    faults = faults_in(sources, lambda path: editing_faults(file_of(path), path.read_text()))
    assert faults == {}


def test_a_step_opened_elsewhere_is_noticed():
    assert editing_faults("panels/x.py", "document.openTransaction('X')\n") != []
    assert editing_faults("panels/x.py", "App.addDocumentObserver(self)\n") != []
    assert editing_faults("editing/transactions.py", "document.openTransaction('X')\n") == []


def file_of(path):
    return path.relative_to(WORKBENCH).as_posix()


def place_of(path):
    parts = path.relative_to(WORKBENCH).with_suffix("").parts
    return "conversion" if parts == ("bridge", "conversion") else parts[0]


def test_only_the_coin_bindings_include_coin():
    for path in files(".h", ".cpp", below=BINDINGS):
        if path.parent.name != "coin":
            assert "Inventor/" not in path.read_text(), label(path)


def test_the_freecad_namespace_stays_a_namespace():
    assert WORKBENCH.is_dir()
    assert not (WORKBENCH.parent / "__init__.py").exists()


@pytest.mark.parametrize(
    ("layer", "line"),
    [
        ("base", '#include "sheetmorph/mesh/triangle_mesh.h"'),
        ("mesh", '#include "sheetmorph/forms/feature_shape.h"'),
        ("fitting", '#include "sheetmorph/mesh/triangle_mesh.h"'),
        ("surface", '#include "sheetmorph/volume/control_mesh.h"'),
        ("volume", '#include "sheetmorph/assembly/part.h"'),
        ("base", "#include <pybind11/pybind11.h>"),
        ("surface", "#include <QWidget>"),
        ("assembly", "  # include <Inventor/SbVec3f.h>"),
        ("numerics", "#include <iostream>"),
    ],
)
def test_a_forbidden_include_is_noticed(layer, line):
    assert len(kernel_faults(layer, f"// comment\n{line}\n")) == 1


@pytest.mark.parametrize(
    ("place", "line"),
    [
        ("api", "import FreeCADGui as Gui"),
        ("api", "def f():\n    from .panels import handle_panel"),
        ("objects", "from ..views.part_view import PartView"),
        ("objects", "from freecad.sheetmorph import panels"),
        ("tools", "import FreeCAD"),
        ("tools", "from pivy import coin"),
        ("commands", "from sheetmorph import _coin"),
        ("views", "from pivy import coin"),
        ("session", "import Mesh"),
        ("panels", "from PySide import QtGui"),
        ("panels", "import numpy as np"),
    ],
)
def test_a_forbidden_import_is_noticed(place, line):
    assert workbench_faults(place, line + "\n") != []


def test_allowed_imports_pass():
    assert kernel_faults("assembly", '#include "sheetmorph/surface/surface_deformer.h"\n') == []
    assert workbench_faults("scene", "from pivy import coin\nfrom sheetmorph import _coin\n") == []
    assert workbench_faults("conversion", "import Mesh\n") == []
    assert package_faults("import numpy\nfrom . import recipe\n") == []


def test_freecad_in_the_package_is_noticed():
    assert package_faults("def f():\n    import FreeCAD\n") == ["the package imports FreeCAD"]
