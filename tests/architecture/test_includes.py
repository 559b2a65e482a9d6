# SPDX-License-Identifier: LGPL-2.1-or-later
"""No two folders of the kernel include each other, directly or by way of others."""
import re

import pytest
from imports import circles
from includes import depths, folder_at, folders_at, kernel_includes, mutual_pairs
from source_tree import KERNEL, files

INCLUDES = kernel_includes(files(".h", ".cpp", below=KERNEL), KERNEL)


@pytest.mark.parametrize("depth", depths(INCLUDES))
def test_no_two_folders_of_the_kernel_include_each_other(depth):
    graph = folders_at(INCLUDES, depth)
    assert len(graph) > 10 and graph["assembly"]
    assert mutual_pairs(graph) == []


@pytest.mark.parametrize("depth", depths(INCLUDES))
def test_the_folders_of_the_kernel_stand_in_no_circle(depth):
    assert circles(folders_at(INCLUDES, depth)) == []


def test_every_included_header_of_the_kernel_exists():
    headers = set().union(*INCLUDES.values())
    assert headers <= set(INCLUDES)


def test_a_source_belongs_to_its_folder_at_every_depth():
    assert folder_at("a/b/c/d.h", 1) == "a"
    assert folder_at("a/b/c/d.h", 3) == folder_at("a/b/c/d.h", 4) == "a/b/c"
    assert folder_at("a/d.h", 2) == "a"


def test_two_folders_that_include_each_other_are_noticed():
    house = {"a/x/one.h": {"a/y/two.h"}, "a/y/two.h": set(), "a/y/two.cpp": {"a/x/one.h"}}
    assert mutual_pairs(folders_at(house, 1)) == []
    assert mutual_pairs(folders_at(house, 2)) == [("a/x", "a/y")]
    house["a/y/two.cpp"] = {"a/y/two.h"}
    assert mutual_pairs(folders_at(house, 2)) == []


def test_a_folder_and_the_folder_above_it_that_include_each_other_are_noticed():
    house = {"a/top.h": {"a/x/one.h"}, "a/x/one.h": set(), "a/x/one.cpp": {"a/top.h"}}
    assert mutual_pairs(folders_at(house, 2)) == [("a", "a/x")]


def test_a_circle_of_three_folders_is_noticed():
    house = {"a/1.h": {"b/2.h"}, "b/2.h": {"c/3.h"}, "c/3.h": set(), "c/3.cpp": {"a/1.h"}}
    assert mutual_pairs(folders_at(house, 1)) == []
    assert circles(folders_at(house, 1)) == [["a", "b", "c"]]


def test_includes_are_read_from_the_sources(tmp_path):
    (tmp_path / "a").mkdir()
    source = tmp_path / "a" / "one.cpp"
    source.write_text('#include "sheetmorph/a/one.h"\n#include <vector>\n#include "other.h"\n')
    assert kernel_includes([source], tmp_path) == {"a/one.cpp": {"a/one.h"}}


def test_a_source_for_every_instruction_set_includes_itself():
    """Another's path would compile that one, without any fault of the compiler."""
    named = {
        path.relative_to(KERNEL.parent).as_posix(): re.findall(
            r'#define HWY_TARGET_INCLUDE "(.+)"', path.read_text()
        )
        for path in files(".cpp", below=KERNEL)
        if "foreach_target.h" in path.read_text()
    }
    assert named
    assert named == {path: [path] for path in named}
