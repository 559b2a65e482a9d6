# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every named number of the kernel says where its value comes from."""
import constants
from source_tree import ROOT, faults_in, files

CORE = files(".h", ".cpp", below=ROOT / "core")


def faults(text: str) -> list[str]:
    """The constants of a text without a source."""
    return constants.numbers_without_source(text)


def test_every_named_number_has_a_source():
    assert CORE
    assert faults_in(CORE, lambda path: faults(path.read_text())) == {}


def test_the_numbers_are_found():
    found = sum(len(constants.NUMBER.findall(path.read_text())) for path in CORE)
    assert found > 200


def test_a_number_without_a_comment_is_noticed():
    assert faults("constexpr double far = 1.8;\n") == ["line 1: far"]
    assert faults("    static constexpr double far = 1.8;\n") == ["line 1: far"]
    assert faults("constexpr std::size_t most = 40;\n") == ["line 1: most"]


def test_a_comment_that_only_repeats_the_name_is_noticed():
    assert faults("// The farthest skin.\nconstexpr double farthest_skin = 1.8;\n")
    assert faults("constexpr double farthest = 1.8;  // relative to the size\n")
    assert faults("// Largest distance from a plane, mm.\nconstexpr double far = 1.8;\n")


def test_a_source_is_found_above_the_number_and_beside_it():
    assert not faults("// From geometry: sqrt(3).\nconstexpr double far = 1.8;\n")
    assert not faults("constexpr double far = 1.8;  // chosen: one pixel\n")


def test_numbers_without_a_blank_line_share_a_comment():
    pair = "constexpr double one = 0.1;\nconstexpr double two = 0.2;\n"
    assert not faults("// Chosen: a tenth.\n" + pair)
    assert faults("// Chosen: a tenth.\nconstexpr int n = 3;\n\n" + pair)


def test_another_name_needs_no_source():
    assert not faults("constexpr double far = other;\n")
    assert not faults("constexpr int none = -1;\n")
    assert not faults("constexpr double all = std::numeric_limits<double>::infinity();\n")
