# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts of the workbench are translated, with the same gaps."""

import importlib.util
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
GAP = re.compile(r"\{\w+\}")


@pytest.fixture(scope="module")
def tool():
    spec = importlib.util.spec_from_file_location("translations", ROOT / "Mod" / "translations.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("language", ["de", "ja"])
def test_the_files_hold_nearly_all_that_the_sources_say(tool, language):
    path = ROOT / "resources" / "translations" / f"SheetMorph_{language}.ts"
    texts = tool.collect(ROOT)
    known = tool.read_translations(path)
    wanted = {(context, text) for context, found in texts.items() for text in found}
    missing = wanted - set(known)
    assert len(missing) < 0.05 * len(wanted), f"run: ninja -C build translations; {missing}"


def test_what_is_written_is_read_again(tool, tmp_path):
    texts = {"a": ["one", "two"], "b": ["one"]}
    known = {("a", "one"): "eins", ("b", "one"): "<ein> & {x}", ("a", "gone"): "weg"}
    path = tmp_path / "x.ts"
    path.write_text(tool.written(texts, known, "de"), "utf-8")
    found = tool.read_translations(path)
    assert found == {("a", "one"): "eins", ("a", "two"): "", ("b", "one"): "<ein> & {x}"}
    assert path.read_text("utf-8").count("unfinished") == 1


@pytest.mark.parametrize("language", ["de", "ja"])
def test_nearly_everything_is_translated_and_gaps_stay(tool, language):
    known = tool.read_translations(
        ROOT / "resources" / "translations" / f"SheetMorph_{language}.ts"
    )
    missing = [text for (_, text), said in known.items() if not said]
    assert len(missing) < 0.05 * len(known), missing
    wrong = [
        text
        for (_, text), said in known.items()
        if said and sorted(GAP.findall(text)) != sorted(GAP.findall(said))
    ]
    assert wrong == []


def test_texts_are_found_in_python_and_panels(tool):
    source = 'a = translate("c", "one " "two")\nb = QT_TRANSLATE_NOOP("d", "x")\nf("c", "no")\n'
    assert tool.texts_of_python(source) == [("c", "one two"), ("d", "x")]
    panel = '<ui><class>p</class><widget><property name="text"><string>A</string></property>'
    panel += '<property name="suffix"><string>°</string></property></widget></ui>'
    assert tool.texts_of_panel(panel) == [("p", "A")]
