# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of mathematics names every equation of the paper, and only what exists."""
import pytest
from mathematics import (
    EQUATIONS,
    Entry,
    entries,
    invariants,
    is_named_in_the_code,
    missing_sources,
    missing_tests,
    pairs,
)
from source_tree import ROOT

PAGE = ROOT / "resources" / "docs" / "mathematics.md"
ENTRIES = entries(PAGE.read_text())
BY_TITLE = pytest.mark.parametrize("entry", ENTRIES, ids=[entry.title for entry in ENTRIES])


def test_every_equation_of_the_paper_has_one_entry():
    numbers = [entry.number() for entry in ENTRIES if entry.number()]
    assert sorted(numbers) == sorted(EQUATIONS)


def test_every_equation_of_the_paper_leads_to_one_function():
    named = {entry.number(): entry.computed for entry in ENTRIES if entry.number()}
    assert {number: found for number, found in named.items() if len(found) != 1} == {}


@BY_TITLE
def test_what_computes_an_equation_exists(entry):
    assert missing_sources(entry) == []


@BY_TITLE
def test_what_holds_an_equation_exists(entry):
    assert entry.held
    assert missing_tests(entry.held) == []


@pytest.mark.parametrize("number", EQUATIONS)
def test_the_code_names_the_equation_where_it_computes_it(number):
    (entry,) = [entry for entry in ENTRIES if entry.number() == number]
    assert is_named_in_the_code(entry)


def test_the_invariants_are_tested():
    named = invariants(PAGE.read_text())
    assert len(named) > 10
    assert missing_tests(named) == []


def test_the_readme_leads_to_the_page():
    assert "resources/docs/mathematics.md" in (ROOT / "README.md").read_text()


@pytest.fixture
def kernel(tmp_path):
    """A kernel of one function in one file, with its header and its test."""
    (tmp_path / "sums.cpp").write_text("int Sum::of(int a)\n{\n    return a;\n}\n")
    (tmp_path / "sums.h").write_text("//! Sums (2.1, 2.10).\nclass Sum\n{\n};\n")
    (tmp_path / "sums_test.cpp").write_text("TEST(Sum, IsOne)\n{\n    EXPECT_EQ(1, sum());\n}\n")
    return tmp_path


def test_an_entry_is_read_from_the_page():
    text = (
        "- **(2.1)** `L` as `K`\n  - computed in `a.cpp`: `f`, `A::g`; `b.h`: `B`\n"
        "  - held by `c_test.cpp`: `C.Holds`\n- **Ours.** more\n"
    )
    first, second = entries(text)
    assert (first.number(), second.number()) == ("2.1", "")
    assert first.computed == [("a.cpp", "f"), ("a.cpp", "A::g"), ("b.h", "B")]
    assert first.held == [("c_test.cpp", "C.Holds")]
    assert missing_sources(second) == ["Ours.: no function computes it"]


def test_what_does_not_exist_is_noticed(kernel):
    there = Entry("(2.1)", pairs("`sums.cpp`: `Sum::of`, `of`; `sums.h`: `Sum`"))
    assert missing_sources(there, kernel) == []
    gone = Entry("(2.1)", pairs("`sums.cpp`: `Sum::off`; `sum.cpp`: `of`; `sums.h`: `Su`"))
    assert missing_sources(gone, kernel) == [
        "(2.1): sums.cpp has no Sum::off",
        "(2.1): no file sum.cpp",
        "(2.1): sums.h has no Su",
    ]
    held = pairs("`sums_test.cpp`: `Sum.IsOne`, `Sum.IsTwo`; `sum_test.cpp`: `Sum.IsOne`")
    assert missing_tests(held, kernel) == ["sums_test.cpp has no Sum.IsTwo", "no file sum_test.cpp"]


def test_an_equation_that_the_code_does_not_name_is_noticed(kernel):
    computed = pairs("`sums.cpp`: `Sum::of`")
    assert is_named_in_the_code(Entry("(2.10)", computed), kernel)
    assert is_named_in_the_code(Entry("(2.1)", computed), kernel)
    assert not is_named_in_the_code(Entry("(2.11)", computed), kernel)


def test_the_table_of_invariants_is_read():
    text = "| a | b |\n|---|---|\n| c | `x_test.cpp` |\n|---|---|\n| d | `A.B`, `A.C` |\n"
    assert invariants(text) == [("x_test.cpp", "A.B"), ("x_test.cpp", "A.C")]
