# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nobody reads in a message what a fault says as such: whom it concerns, where, what to do."""
import pytest
from messages import reading_faults
from source_tree import ROOT, faults_in, files

PACKAGE = ROOT / "bindings" / "python"
WORKBENCH = ROOT / "Mod"
FOREIGN = {
    "bindings/python/sheetmorph/recipe/reading.py",  # tomllib tells line and column in words alone
}


def sources():
    found = [*files(".py", below=PACKAGE), *files(".py", below=WORKBENCH)]
    return [p for p in found if "tests" not in p.parts and str(p.relative_to(ROOT)) not in FOREIGN]


def test_messages_are_written_and_never_read():
    assert faults_in(sources(), lambda path: reading_faults(path.read_text())) == {}


@pytest.mark.parametrize(
    "text",
    [
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
