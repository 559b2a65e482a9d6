# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the guide says at every stage of a morph; needs no FreeCAD."""

from dataclasses import replace

from freecad.sheetmorph.tools import guide
from freecad.sheetmorph.tools.guide import Facts

ONE = Facts(morphs=1, parts=("cover",), primary="cover")
READY = replace(ONE, fixed=1, features=4, handles=1)
THREE = replace(READY, parts=("cover", "frame", "foot"))


def states(facts: Facts) -> dict[str, str]:
    """The states of all steps."""
    return {step.key: step.state for step in guide.steps(facts)}


def text(facts: Facts, key: str) -> str:
    """The words of one step."""
    step = next(step for step in guide.steps(facts) if step.key == key)
    return step.text.format(**step.values)


def test_an_empty_document_begins_with_parts():
    assert states(Facts())["parts"] == guide.NEXT
    assert "Import a mesh" in text(Facts(), "parts")
    assert list(states(Facts())) == list(guide.STEPS)


def test_a_morph_without_parts_asks_for_one_and_several_morphs_for_a_choice():
    assert "no part yet" in text(Facts(morphs=1), "parts")
    assert "select one" in text(Facts(morphs=2), "parts")


def test_one_step_after_the_other_is_next():
    order = [ONE, replace(ONE, fixed=1), replace(ONE, fixed=1, features=2), READY]
    wanted = ["fixed", "features", "handle", "drag"]
    for facts, key in zip(order, wanted):
        assert [k for k, state in states(facts).items() if state == guide.NEXT] == [key]


def test_after_an_optional_step_one_may_go_on():
    assert states(replace(ONE, fixed=1))["handle"] == guide.AFTER
    apart = replace(ONE, parts=("cover", "foot"), fixed=1, features=1)
    assert states(apart)["contacts"] == guide.NEXT and states(apart)["handle"] == guide.AFTER
    assert guide.AFTER not in states(READY).values()


def test_features_are_passed_over_once_a_handle_is_there():
    found = states(replace(READY, features=0))
    assert found["features"] == guide.OPTIONAL and found["drag"] == guide.NEXT


def test_nothing_is_next_when_all_is_done():
    found = states(replace(READY, is_moved=True))
    assert set(found.values()) == {guide.DONE}


def test_parts_that_nothing_reaches_are_named():
    joined = replace(THREE, joined=(("foot", "frame"),), handles=0)
    assert "frame, foot" in text(joined, "contacts")
    chain = replace(THREE, joined=(("foot", "frame"), ("frame", "cover")))
    assert states(chain)["contacts"] == guide.DONE
    assert states(replace(THREE, is_single=True))["contacts"] == guide.DONE


def test_a_failure_is_told_at_the_step_it_belongs_to():
    sentence = "Region 'tip' has no vertices; pick some or delete it."
    found = replace(READY, failure=sentence, faulty_role="handle")
    assert states(found)["handle"] == guide.FAULTY and text(found, "handle") == sentence
    assert guide.NEXT not in states(found).values()
    assert states(replace(READY, failure="?"))["drag"] == guide.FAULTY
    assert states(replace(READY, failure="?", faulty_role="contact"))["contacts"] == guide.FAULTY


def test_an_edited_body_is_told_until_its_part_follows():
    edited = replace(READY, edited=("Body", "cover"))
    assert text(edited, "parts") == "“Body” was edited: use Follow Shape to update “cover”."
    assert states(edited)["parts"] == guide.OPTIONAL
    assert [key for key, state in states(edited).items() if state == guide.NEXT] == ["drag"]
    assert states(replace(edited, edited=("", "")))["parts"] == guide.DONE
