# SPDX-License-Identifier: LGPL-2.1-or-later
"""Habits the style guide rules out, as functions from a source text to its faults."""
import ast
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
