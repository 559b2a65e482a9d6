# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts of the workbench are translated, with the same gaps."""

import ast
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
    row = 'Command("SheetMorph_X", "&Do", "Does it", needs.PART, act)'
    assert tool.texts_of_python(row) == [("SheetMorph_X", "&Do"), ("SheetMorph_X", "Does it")]
    panel = '<ui><class>p</class><widget><property name="text"><string>A</string></property>'
    panel += '<property name="suffix"><string>°</string></property></widget></ui>'
    assert tool.texts_of_panel(panel) == [("p", "A")]


def test_all_contexts_are_of_one_name_space(tool):
    """Texts of all of FreeCAD lie beside ours; it asks for titles of menus and toolbars itself."""
    foreign = [name for name in tool.collect(ROOT) if not name.startswith("SheetMorph_")]
    assert foreign == ["Workbench"]


LETTER = re.compile(r"&(\w)")


@pytest.fixture(scope="module")
def menus(tool) -> dict[str, list[tuple[str, str]]]:
    """Texts with their contexts, by menu: the submenus are in the first menu, ""."""
    table = ROOT / "Mod/SheetMorph/freecad/sheetmorph/commands/table.py"
    tree = ast.parse(table.read_text("utf-8"))
    calls = [n for n in ast.walk(tree) if isinstance(n, ast.Call)]
    rows = [c.args[:2] for c in calls if getattr(c.func, "id", "") == "Command"]
    texts = {row[0].value.removeprefix("SheetMorph_"): (row[0].value, row[1].value) for row in rows}
    assigned = [n for n in tree.body if isinstance(n, ast.Assign)]
    (menu,) = [n.value for n in assigned if ast.unparse(n.targets[0]) == "MENU"]
    titles = [words_in(key.args[1] if isinstance(key, ast.Call) else key)[0] for key in menu.keys]
    found = {
        title: [texts[name] for name in ast.literal_eval(row).split() if name != "|"]
        for title, row in zip(titles, menu.values)
    }
    found[""] += [("Workbench", title) for title in titles if title]
    return found


@pytest.mark.parametrize("language", ["en", "de", "ja"])
def test_every_entry_of_a_menu_has_a_letter_of_its_own(tool, menus, language):
    path = ROOT / "resources" / "translations" / f"SheetMorph_{language}.ts"
    known = tool.read_translations(path)
    known |= {("Workbench", "&Help"): {"de": "&Hilfe", "ja": "ヘルプ(&H)"}.get(language, "")}
    assert len(menus) == 8 and sum(map(len, menus.values())) > 40
    for title, entries in menus.items():
        said = [known.get(entry) or entry[1] for entry in entries]
        letters = [letter.lower() for text in said for letter in LETTER.findall(text)]
        assert len(letters) == len(said), (title, said)
        assert len(set(letters)) == len(letters), (title, said)


SHOWING = {"setText", "setToolTip", "setStatusTip", "setWhatsThis", "setTitle", "setWindowTitle"}
SHOWING |= {"setLabelText", "setPlaceholderText", "setPrefix", "setSuffix", "addItem", "addItems"}
SHOWING |= {"addAction", "addButton", "addMenu", "addTab", "setHeaderLabels", "showMessage"}
SHOWING |= {"QLabel", "QPushButton", "QCheckBox", "QAction", "QToolButton", "QProgressDialog"}
SHOWING |= {"information", "warning", "critical", "question", "QMessageBox"}
SHOWING |= {"getDouble", "getInt", "getItem", "getText"}
SHOWING |= {"getExistingDirectory", "getOpenFileName", "getOpenFileNames", "getSaveFileName"}
NO_WORDS = re.compile(r"<[^>]*>?|[^<]*>|\w+\.json")  # markup, names of files


def words_in(node: ast.expr) -> list[str]:
    """The literal texts that an expression may give, but what functions make of theirs."""
    if isinstance(node, ast.Constant):
        return [node.value] if isinstance(node.value, str) else []
    inner = {
        ast.JoinedStr: lambda: node.values,
        ast.List: lambda: node.elts,
        ast.Tuple: lambda: node.elts,
        ast.Starred: lambda: [node.value],
        ast.IfExp: lambda: [node.body, node.orelse],
        ast.BinOp: lambda: [node.left, node.right],
    }.get(type(node), list)
    return [text for each in inner() for text in words_in(each)]


def test_what_a_widget_is_told_to_show_is_marked(tool):
    workbench = ROOT / "Mod" / "SheetMorph" / "freecad" / "sheetmorph"
    unmarked, seen = [], 0
    for path in sorted(workbench.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if "tests" in path.parts or not isinstance(node, ast.Call):
                continue
            if getattr(node.func, "attr", getattr(node.func, "id", "")) not in SHOWING:
                continue
            seen += 1
            said = [NO_WORDS.sub("", text) for value in node.args for text in words_in(value)]
            if any(re.search(r"[A-Za-z]{2}", text) for text in said):
                unmarked.append(f"{path.name}:{node.lineno}: {said}")
    assert seen > 50
    assert unmarked == []
