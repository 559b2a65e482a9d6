# SPDX-License-Identifier: LGPL-2.1-or-later
"""No folder of the kernel is crowded, no name is taken twice, tests lie where their source does."""
from pathlib import Path

import pytest
from rooms import (
    FULLEST_FOLDER,
    classes_of,
    fullness_faults,
    is_misplaced,
    names_twice,
    rooms_on_disk,
    rooms_told,
)
from source_tree import BINDINGS, KERNEL, ROOT, files, label

TESTS = ROOT / "tests" / "core"
PAGE = ROOT / "resources" / "docs" / "contributing" / "architecture.md"
KERNEL_SOURCES = files(".h", ".cpp", below=KERNEL)


def test_no_folder_of_the_kernel_is_crowded():
    assert fullness_faults(KERNEL_SOURCES) == {}


def test_no_two_sources_define_a_class_of_one_name_in_one_namespace():
    assert names_twice(KERNEL_SOURCES + files(".h", ".cpp", below=BINDINGS)) == {}


def test_a_test_lies_where_its_source_does():
    tests = [path for path in files(".cpp", below=TESTS) if path.name.endswith("_test.cpp")]
    assert tests
    assert [label(test) for test in tests if is_misplaced(test, TESTS, KERNEL)] == []


def test_the_manual_lists_the_layers_and_their_rooms():
    assert rooms_told(PAGE.read_text()) == rooms_on_disk(KERNEL)


def test_a_room_that_the_page_leaves_out_is_noticed(tmp_path):
    (tmp_path / "mesh" / "quality").mkdir(parents=True)
    (tmp_path / "base").mkdir()
    table = "| layer | what | its rooms |\n|---|---|---|\n| `base` | a | |\n| `mesh` | b | ROOM |\n"
    assert rooms_told(table) == {"base": set(), "mesh": set()} != rooms_on_disk(tmp_path)
    assert rooms_told(table.replace("ROOM", "`quality`")) == rooms_on_disk(tmp_path)


def test_a_crowded_folder_is_noticed():
    crowd = [Path(f"mesh/{number}.h") for number in range(FULLEST_FOLDER + 1)]
    assert fullness_faults([*crowd[1:], Path("base/one.h")]) == {}
    assert fullness_faults(crowd) == {"mesh": FULLEST_FOLDER + 1}


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("namespace a\n{\nclass B\n{\n    struct C\n    {\n    };\n};\n}", ["a::B"]),
        ("namespace a\n{\nnamespace\n{\nstruct B : C<D>\n{\n};\n}\n}", ["a::mine::B"]),
        ("namespace a::b\n{\nenum class C : char\n{\n    d\n};\n}", ["a::b::C"]),
        ("namespace a\n{\nclass B;  // class C {};\nvoid f()\n{\n    struct D {};\n}\n}", []),
        ("namespace a\n{\nstruct B::C\n{\n};\n}", ["a::B::C"]),
        ("namespace a\n{\ntemplate <class T>\nclass B\n{\n};\n}", ["a::B"]),
        ("namespace a\n{\ntemplate <class T>\nint f(T one)\n{\n    return one;\n}\n}", []),
    ],
)
def test_classes_are_found_with_their_namespaces(text, names):
    assert classes_of(text, "mine") == names


def test_a_name_taken_twice_is_noticed(tmp_path):
    one, other = tmp_path / "one.h", tmp_path / "other.h"
    one.write_text("namespace a\n{\nclass B\n{\n};\n}")
    other.write_text("namespace a\n{\nnamespace\n{\nclass B\n{\n};\n}\n}")
    assert names_twice([one, other]) == {}
    other.write_text("namespace a\n{\nstruct B\n{\n};\n}")
    assert names_twice([one, other]) == {"a::B": [one.as_posix(), other.as_posix()]}


def test_a_misplaced_test_is_noticed(tmp_path):
    source = tmp_path / "kernel" / "mesh" / "quality" / "quality.h"
    source.parent.mkdir(parents=True)
    source.touch()
    tests, kernel = tmp_path / "tests", tmp_path / "kernel"
    assert not is_misplaced(tests / "mesh/quality/quality_test.cpp", tests, kernel)
    assert not is_misplaced(tests / "mesh/quality/worst_corners_test.cpp", tests, kernel)
    assert is_misplaced(tests / "mesh/quality_test.cpp", tests, kernel)
    assert is_misplaced(tests / "mesh/beauty/worst_corners_test.cpp", tests, kernel)
