# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures the length of functions of both languages in lines."""
import ast
import re
from dataclasses import dataclass

LONGEST_FUNCTION = 40
LONGEST_HEADER = 150
LONGEST_SOURCE = 600

NOT_CODE = re.compile(
    r"//[^\n]*|/\*.*?\*/|R\"\((?:.*?)\)\"|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])'", re.DOTALL
)
PREPROCESSOR = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
DECORATION = re.compile(
    r"template\s*<(?:[^<>]|<[^<>]*>)*>|\b(?:public|private|protected)\s*:|"
    r"__attribute__\(\(.*\)\)\)?"
)
SCOPE = re.compile(r"\b(namespace|class|struct|union|enum|extern)\b")
CONTROL = re.compile(r"^(if|for|while|switch|do|else|try|catch)\b")
ENDS_A_HEAD = re.compile(r"\)\s*(const|noexcept|override|final|\s)*$")


@dataclass
class Function:
    """One function definition as it stands in a source."""

    name: str
    line: int
    lines: int

    def faults(self) -> list[str]:
        """What is too big about it."""
        if self.lines > LONGEST_FUNCTION:
            return [f"line {self.line}: {self.name} has {self.lines} lines"]
        return []


def python_functions(text: str) -> list[Function]:
    """Return every function of a Python source; its docstring does not count."""
    found = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            lines = (node.end_lineno or node.lineno) - node.lineno + 1
            if ast.get_docstring(node) is not None:
                lines -= (node.body[0].end_lineno or 0) - node.body[0].lineno + 1
            found.append(Function(node.name, node.lineno, lines))
    return found


def blank(match: re.Match) -> str:
    """Spaces instead of what was matched; its line breaks stay."""
    return re.sub(r"[^\n]", " ", match.group())


class CppReader:
    """Reads a clang-formatted C++ source brace by brace and collects its functions."""

    def __init__(self, text: str):
        self.code = PREPROCESSOR.sub(blank, NOT_CODE.sub(blank, text))
        self.code = DECORATION.sub(blank, self.code).replace("operator()", "operator_c")
        self.functions: list[Function] = []
        self._open: list = []  # "scope", "inner" or the Function each open brace belongs to
        self._head = 0  # where the present declaration begins

    def read(self) -> list[Function]:
        """Every function with a body; lambdas belong to the function around them."""
        for mark in re.finditer(r"[{};]", self.code):
            is_declaration = all(scope == "scope" for scope in self._open)
            if mark.group() == "{":
                self._open.append(self._opened(mark.start()) if is_declaration else "inner")
                is_declaration = self._open[-1] == "scope"
            elif mark.group() == "}" and self._open:
                is_declaration = self._close(mark.start())
            if is_declaration:
                self._head = mark.end()
        return self.functions

    def _opened(self, brace: int):
        head = self.code[self._head : brace].strip()
        is_first_on_line = self.code[:brace].rpartition("\n")[2].strip() == ""
        if SCOPE.search(head.split("(")[0]):
            return "scope"
        if "(" not in head or CONTROL.match(head):
            return "inner"
        if not is_first_on_line and not ENDS_A_HEAD.search(head):
            return "inner"  # a braced initialiser
        name = re.search(r"(operator\S*|[~\w:]+)\s*\($", head[: head.index("(") + 1])
        line = self.code.count("\n", 0, brace) - head.count("\n") + 1 - is_first_on_line
        return Function(name.group(1) if name else "?", line, 0)

    def _close(self, brace: int) -> bool:
        opened = self._open.pop()
        if isinstance(opened, Function):
            opened.lines = self.code.count("\n", 0, brace) + 2 - opened.line
            self.functions.append(opened)
        return opened != "inner"


def cpp_functions(text: str) -> list[Function]:
    """Every function with a body of a C++ source."""
    return CppReader(text).read()
