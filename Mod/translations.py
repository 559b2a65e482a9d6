# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings the translation files up to date with the texts in the sources; keeps what is translated.

Called by the CMake target `translations`: translations.py REPOSITORY
pylupdate5 loses texts that are put together of several pieces, hence a reader of our own. The
files are Qt Linguist's; lrelease compiles them when the add-on is built.
"""
import ast
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

LANGUAGES = ("de", "ja")
MARKS = ("translate", "QT_TRANSLATE_NOOP")
COMMAND = "Command"  # a row of the table of commands: name, text and tooltip come first
SHOWN = {"text", "title", "windowTitle", "toolTip", "statusTip", "whatsThis", "placeholderText"}
SHOWN |= {"suffix", "prefix", "specialValueText"}
Texts = dict[str, list[str]]
"""Texts by context, in their order."""


def texts_of_python(source: str) -> list[tuple[str, str]]:
    """The (context, text) pairs that a Python source marks for translation."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call):
            name = getattr(node.func, "id", getattr(node.func, "attr", ""))
            values = [getattr(argument, "value", None) for argument in node.args]
            count = 3 if name == COMMAND else 2 if name in MARKS and len(values) == 2 else 0
            if count and all(isinstance(value, str) for value in values[:count]):
                found += [(values[0], text) for text in values[1:count]]
    return found


def texts_of_panel(source: str) -> list[tuple[str, str]]:
    """The (context, text) pairs of a panel's widgets, as Qt's loader asks for them."""
    root = ET.fromstring(source)
    context = root.findtext("class")
    found = []
    for owner in root.iter("property"):
        text = owner.findtext("string")
        if owner.get("name") in SHOWN and text and any(letter.isalpha() for letter in text):
            found.append((context, text))
    return found


def collect(repository: Path) -> Texts:
    """All texts of the workbench."""
    pairs = []
    workbench = repository / "Mod" / "SheetMorph" / "freecad" / "sheetmorph"
    for path in sorted(workbench.rglob("*.py")):
        if "tests" not in path.relative_to(workbench).parts:
            pairs += texts_of_python(path.read_text("utf-8"))
    for path in sorted((repository / "resources" / "panels").glob("*.ui")):
        pairs += texts_of_panel(path.read_text("utf-8"))
    found: Texts = {}
    for context, text in pairs:
        if text not in found.setdefault(context, []):
            found[context].append(text)
    return dict(sorted(found.items()))


def read_translations(path: Path) -> dict[tuple[str, str], str]:
    """What a translation file says by (context, text)."""
    if not path.is_file():
        return {}
    found = {}
    for context in ET.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            said = message.findtext("translation") or ""
            found[context.findtext("name"), message.findtext("source")] = said
    return found


def written(texts: Texts, known: dict[tuple[str, str], str], language: str) -> str:
    """A translation file of all texts; those not translated yet are marked unfinished."""
    root = ET.Element("TS", version="2.1", language=language, sourcelanguage="en")
    for name, sources in texts.items():
        context = ET.SubElement(root, "context")
        ET.SubElement(context, "name").text = name
        for source in sources:
            message = ET.SubElement(context, "message")
            ET.SubElement(message, "source").text = source
            said = known.get((name, source), "")
            translation = ET.SubElement(message, "translation")
            translation.text = said
            if not said:
                translation.set("type", "unfinished")
    ET.indent(root, " ")
    licence = "<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->"
    head = f'<?xml version="1.0" encoding="utf-8"?>\n{licence}\n<!DOCTYPE TS>\n'
    return head + ET.tostring(root, "unicode", short_empty_elements=False) + "\n"


def refresh(repository: Path) -> None:
    """Writes the translation files of all languages anew."""
    texts = collect(repository)
    folder = repository / "resources" / "translations"
    folder.mkdir(exist_ok=True)
    for language in LANGUAGES:
        path = folder / f"SheetMorph_{language}.ts"
        path.write_text(written(texts, read_translations(path), language), "utf-8")


if __name__ == "__main__":
    refresh(Path(sys.argv[1]))
