# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each layer of the kernel has one namespace, its tests too, and no header opens one to all."""
import pytest
from layers import MAY_INCLUDE
from namespaces import header_faults, helper_faults, kernel_faults
from source_tree import KERNEL, ROOT, faults_in, files

TESTS = ROOT / "tests" / "core"


def test_a_kernel_source_opens_the_namespace_of_its_layer_only():
    def faults(path):
        return kernel_faults(path.relative_to(KERNEL).parts[0], path.read_text())

    assert faults_in(files(".h", ".cpp", below=KERNEL), faults) == {}


def test_a_test_is_in_the_namespace_of_its_layer():
    tests = {
        path: path.relative_to(TESTS).parts[0]
        for path in files(".h", ".cpp", below=TESTS)
        if path.relative_to(TESTS).parts[0] in MAY_INCLUDE
    }
    assert set(tests.values()) == set(MAY_INCLUDE)
    assert faults_in(tests, lambda path: helper_faults(tests[path], path.read_text())) == {}


def test_no_header_uses_a_namespace_as_a_whole():
    assert faults_in(files(".h"), lambda path: header_faults(path.read_text())) == {}


@pytest.mark.parametrize(
    ("layer", "text", "faults"),
    [
        ("mesh", "namespace sheetmorph::mesh\n{\nnamespace\n{\n}\n}", []),
        ("base", "namespace sheetmorph\n{\n}  // namespace sheetmorph::mesh {", []),
        ("cad", "namespace std\n{\n}\nnamespace sheetmorph::cad\n{\n}", []),
        ("cad", "namespace processing = CGAL;\nnamespace sheetmorph::cad\n{\n}", []),
        (
            "mesh",
            "namespace sheetmorph\n{\n}",
            ["does not open sheetmorph::mesh", "opens sheetmorph"],
        ),
        (
            "mesh",
            "namespace sheetmorph::mesh\n{\n}\nnamespace sheetmorph::cad\n{\nclass A;\n}",
            ["opens sheetmorph::cad"],
        ),
        (
            "volume",
            "namespace sheetmorph::volume\n{\nusing mesh::A;\nusing namespace mesh;\n}",
            ["uses all of mesh"],
        ),
    ],
)
def test_another_namespace_is_noticed(layer, text, faults):
    assert kernel_faults(layer, text) == faults


def test_a_helper_outside_the_layer_of_its_test_is_noticed():
    assert helper_faults("mesh", "namespace sheetmorph::mesh::cases\n{\n}") == []
    assert helper_faults("mesh", "namespace sheetmorph::meshes\n{\n}") != []
    assert helper_faults("base", "namespace sheetmorph::test\n{\n}") == []


def test_a_namespace_used_as_a_whole_is_noticed():
    assert header_faults("using mesh::A;  // using namespace b\n") == []
    assert header_faults("using namespace sheetmorph::mesh;\n") == ["uses all of sheetmorph::mesh"]
