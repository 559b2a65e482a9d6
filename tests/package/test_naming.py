# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whom a sentence about a morph names; needs no FreeCAD."""

from freecad.sheetmorph.tools.naming import named_in


def test_labels_are_found_as_whole_words_in_the_order_of_the_sentence():
    sentence = "'Fixed' and hole 12 contradict each other"
    assert named_in(sentence, ["hole 1", "hole 12", "Fixed", "xed", ""]) == ["Fixed", "hole 12"]


def test_of_two_labels_at_one_place_the_longer_is_meant():
    assert named_in("take it out of Tip 2", ["Tip", "Tip 2"]) == ["Tip 2"]


def test_who_is_named_twice_is_found_once():
    assert named_in("A and B: take it out of A", ["B", "A"]) == ["A", "B"]
