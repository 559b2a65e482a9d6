# SPDX-License-Identifier: LGPL-2.1-or-later
"""Habits the style guide rules out, as functions from a source text to its faults."""
import ast
import builtins
import re

SPDX = "SPDX-License-Identifier: LGPL-2.1-or-later"
# Put together here, so that this file does not hold the words it looks for.
LEFT_OPEN = re.compile(
    r"\b(" + "|".join(("TO" + "DO", "FIX" + "ME", "XX" + "X", "HA" + "CK")) + r")\b"
)
UNFINISHED = "NotImplemented" + "Error"
CPP_TEST = re.compile(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+),\s*(\w+)\)\n\{\n(.*?)^\}", re.M | re.S)
CPP_CLAIM = re.compile(r"\b(EXPECT|ASSERT|FAIL|ADD_FAILURE|expect|check|assert)\w*\s*\(")
QT_SIGNALS = set(
    "activated canceled cellDoubleClicked cellEntered clicked currentIndexChanged"
    " currentTextChanged editingFinished itemChanged itemSelectionChanged rejected"
    " returnPressed textChanged textEdited timeout toggled triggered valueChanged".split()
)
PYTHON_CLAIM = re.compile(r"^(assert|expect|check|raises|warns|fail)", re.IGNORECASE)


def text_faults(text: str) -> list[str]:
    """Missing licence line, work left open."""
    faults = []
    if SPDX not in "\n".join(text.splitlines()[:5]):
        faults.append("the SPDX line is missing")
    faults += [f"work left open: {word}" for word in LEFT_OPEN.findall(text)]
    if UNFINISHED in text:
        faults.append(f"unfinished: {UNFINISHED}")
    return faults


def python_faults(text: str) -> list[str]:
    """Mutable module state, swallowed errors, assertions that cannot fail; and protocols that are
    asked at run time, which fails inside FreeCAD since Python 3.13 if they have data."""
    faults = []
    for node in ast.walk(ast.parse(text)):
        line = getattr(node, "lineno", 0)
        if isinstance(node, ast.Global):
            faults.append(f"line {line}: global {', '.join(node.names)}")
        if isinstance(node, ast.ExceptHandler) and node.type is None:
            faults.append(f"line {line}: an except without a name")
        if isinstance(node, ast.Assert) and isinstance(node.test, ast.Constant):
            faults.append(f"line {line}: an assertion that cannot fail")
        if isinstance(node, ast.ImportFrom) and "runtime_checkable" in (n.name for n in node.names):
            faults.append(f"line {line}: a protocol that is asked at run time")
    return faults


def signals_read(text: str) -> list[str]:
    """Signals of Qt's objects that are read as attributes: PySide2 never frees their wrappers."""
    return [
        f"line {node.lineno}: qt.connect() instead of {node.value.attr}.{node.attr}()"
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.Attribute)
        and node.attr in ("connect", "disconnect", "emit")
        and isinstance(node.value, ast.Attribute)
        and node.value.attr in QT_SIGNALS
    ]


def wrong_slots(text: str) -> list[str]:
    """Methods connected to a signal that sends fewer or more values than they take.

    Qt reports such a call in the report view only, and the widget appears to do nothing.
    """
    tree, faults = ast.parse(text), []
    methods = {n.name: n.args for n in ast.walk(tree) if isinstance(n, ast.FunctionDef)}
    for call in ast.walk(tree):
        match call:
            case ast.Call(
                func=ast.Name(id="connect"),
                args=[_, ast.Constant(value=str(signal)), ast.Attribute(attr=name)],
            ) if name in methods:
                sent = len(re.findall(r"\w+", signal)) - 1
                most = len(methods[name].args) - 1  # without self
                fewest = most - len(methods[name].defaults)
                if sent < fewest or (sent > most and methods[name].vararg is None):
                    faults.append(f"line {call.lineno}: {signal} of {name}")
    return faults


def timed_waits(text: str) -> list[str]:
    """Waits of a GUI test for a time in place of a condition."""
    return [
        f"line {node.lineno}: a wait for {node.value.value} ms"
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.Yield) and isinstance(node.value, ast.Constant)
    ]


def called_names(node: ast.AST) -> set[str]:
    """The names of everything called inside a node, without what they are called on."""
    functions = [part.func for part in ast.walk(node) if isinstance(part, ast.Call)]
    attributes = {f.attr.lstrip("_") for f in functions if isinstance(f, ast.Attribute)}
    return attributes | {f.id.lstrip("_") for f in functions if isinstance(f, ast.Name)}


def makes_a_claim(node: ast.AST, helpers: set[str]) -> bool:
    """True if a function asserts, or calls a helper that does or is named after asserting."""
    called = called_names(node)
    is_assert = any(isinstance(part, ast.Assert) for part in ast.walk(node))
    return is_assert or bool(called & helpers) or any(map(PYTHON_CLAIM.match, called))


def python_tests_without_claim(text: str) -> list[str]:
    """Test functions that cannot fail but by accident; helpers of the same file count."""
    functions = [n for n in ast.walk(ast.parse(text)) if isinstance(n, ast.FunctionDef)]
    helpers: set[str] = set()
    for _ in functions:
        helpers |= {f.name.lstrip("_") for f in functions if makes_a_claim(f, helpers)}
    tests = [function for function in functions if function.name.startswith("test")]
    return [test.name for test in tests if not makes_a_claim(test, helpers)]


def cpp_tests_without_claim(text: str) -> list[str]:
    """GoogleTest cases that cannot fail but by accident."""
    cases = CPP_TEST.findall(text)
    return [f"{suite}.{name}" for suite, name, body in cases if not CPP_CLAIM.search(body)]


def hidden_builtins(text: str) -> list[str]:
    """Variables, functions and imports that hide a builtin; fields of a class hide none."""
    tree = ast.parse(text)
    classes = [node for node in ast.walk(tree) if isinstance(node, ast.ClassDef)]
    fields = {id(part) for one in classes for node in one.body for part in field_names(node)}
    return [
        f"line {node.lineno}: {name} hides a builtin"
        for node in ast.walk(tree)
        for name in made_names(node) & set(dir(builtins))
        if id(node) not in fields
    ]


def field_names(node: ast.AST) -> list[ast.AST]:
    """What names a field or a method in the body of a class."""
    return [node, *getattr(node, "targets", []), *filter(None, [getattr(node, "target", None)])]


def made_names(node: ast.AST) -> set[str]:
    """The names that a node gives to something."""
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
        return {node.id}
    if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
        return {node.name}
    if isinstance(node, (ast.Import, ast.ImportFrom)):
        return {alias.asname or alias.name for alias in node.names}
    return set()
