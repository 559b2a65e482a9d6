# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the types of a compiled module for type checkers: stubs.py MODULE STUB

They are read from the signatures that pybind11 puts before its documentation.
"""
import ast
import importlib.util
import re
import sys
from pathlib import Path
from types import ModuleType

HEAD = """# Made at build time by bindings/stubs.py from the compiled module.
from collections.abc import Callable, Sequence
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from sheetmorph.base.errors import FailedError, InputError

"""
SIGNATURE = re.compile(r"^(?:\d+\. )?(\w+)\((.*)\) -> (.+)$", re.MULTILINE)
NOTED = "typing.Annotated["
BARE = {"list": "list[Any]", "tuple": "tuple[Any, ...]", "dict": "dict[str, Any]"}
BARE |= {"numpy.ndarray": "NDArray[Any]", "handle": "Any", "function": "Callable[..., Any]"}


def loaded(path: Path) -> ModuleType:
    """The compiled module, under the name that it has in the package."""
    package = ModuleType("sheetmorph")  # the sources alone: the package needs what a build may lack
    package.__path__ = [str(Path(__file__).resolve().parent / "python" / "sheetmorph")]
    sys.modules["sheetmorph"] = package
    name = f"sheetmorph.{path.name.split('.')[0]}"
    spec = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def plain(text: str, module: str) -> str:
    """A type as a stub writes it; Any for what is none in Python."""
    text = without_notes(re.sub(rf"{module}\.|sheetmorph::(\w+::)*", "", text.strip()))
    text = re.sub(
        r"numpy\.ndarray\[numpy\.(\w+)(\[[^]]*\])?(, flags\.\w+)?\]", r"NDArray[np.\1]", text
    )
    text = re.sub(r"\b(int|float)\[\d+\]", r"\1", text)  # a list of so many
    text = text.replace("List[", "list[").replace("Tuple[", "tuple[").replace("Dict[", "dict[")
    text = BARE.get(text, text)
    try:
        ast.parse(text, mode="eval")
    except SyntaxError:
        return "Any"
    return text


def without_notes(text: str) -> str:
    """A type as pybind11 2 tells it; that of pybind11 3 notes what else is taken, and shapes."""
    while NOTED in text:
        start = text.rindex(NOTED)
        end, depth = start + len(NOTED), 1
        while depth > 0:
            depth += (text[end] == "[") - (text[end] == "]")
            end += 1
        kind, *notes = pieces(text[start + len(NOTED) : end - 1])
        if kind == "numpy.typing.ArrayLike":
            kind = f"numpy.typing.NDArray[{notes[0]}]"
        text = text[:start] + kind + text[end:]
    text = re.sub(r"numpy\.typing\.NDArray\[numpy\.(\w+)\]", r"NDArray[np.\1]", text)
    text = re.sub(r"typing\.SupportsInt \| typing\.SupportsIndex", "int", text)
    text = re.sub(r"typing\.SupportsFloat \| typing\.SupportsIndex", "float", text)
    return text.replace("collections.abc.", "")


def given(text: str, module: str) -> str:
    """The type of what is passed: what takes a list takes a tuple too."""
    return re.sub(r"\blist\[", "Sequence[", plain(text, module))


def pieces(arguments: str) -> list[str]:
    """The arguments of a signature, between commas that stand in no bracket."""
    found, depth = [""], 0
    for letter in arguments:
        depth += (letter in "([{<") - (letter in ")]}>")
        if letter == "," and depth == 0:
            found.append("")
        else:
            found[-1] += letter
    return [piece.strip() for piece in found if piece.strip()]


def argument(text: str, module: str) -> str:
    """One argument; what it is by default is not told."""
    name, _, rest = text.partition(":")
    if name.startswith("*") or name == "self" or not rest:
        return name
    kind, has_default, _ = rest.partition(" = ")
    return f"{name}: {given(kind, module)}" + (" = ..." if has_default else "")


def function(name: str, doc: str, module: str, indent: str = "") -> list[str]:
    """The lines of a function or a method, one a way to call it."""
    found = [mark for mark in SIGNATURE.finditer(doc or "") if mark.group(1) == name]
    if not found:
        return [f"{indent}def {name}(*args: Any, **keys: Any) -> Any: ..."]
    lines = []
    for mark in found:
        told = [argument(piece, module) for piece in pieces(mark.group(2))]
        lines += [f"{indent}@overload"] if len(found) > 1 else []
        lines.append(
            f"{indent}def {name}({', '.join(told)}) -> {plain(mark.group(3), module)}: ..."
        )
    return lines


def value(name: str, member: property, module: str) -> list[str]:
    """The lines of a property."""
    found = re.search(r"\) -> (.+)", (member.fget.__doc__ or "") if member.fget else "")
    kind = plain(found.group(1), module) if found else "Any"
    lines = ["    @property", f"    def {name}(self) -> {kind}: ..."]
    if member.fset is not None:
        mark = SIGNATURE.search(re.sub(r"^\(", "set(", member.fset.__doc__ or ""))
        kind = given(pieces(mark.group(2))[1].partition(":")[2], module) if mark else "Any"
        lines += [f"    @{name}.setter", f"    def {name}(self, value: {kind}) -> None: ..."]
    return lines


def is_made(key: str, member: object) -> bool:
    """Whether this is the constructor of a class that has one."""
    return key == "__init__" and SIGNATURE.search(member.__doc__ or "") is not None


def described(name: str, thing: type, module: str) -> list[str]:
    """The lines of a class."""
    ours = {"pybind11_object", "object"}
    bases = ", ".join(base.__name__ for base in thing.__bases__ if base.__name__ not in ours)
    lines = [f"class {name}({bases}):" if bases else f"class {name}:"]
    for key, member in sorted(vars(thing).items()):
        if isinstance(member, property):
            lines += value(key, member, module)
        elif callable(member) and (not key.startswith("_") or is_made(key, member)):
            lines += function(key, member.__doc__, module, "    ")
    return lines if len(lines) > 1 else [f"{lines[0]} ..."]


def stub_of(module: ModuleType) -> str:
    """The text of the stub."""
    lines: list[str] = []
    for name, thing in sorted(vars(module).items()):
        if name.startswith("_") or isinstance(thing, ModuleType):
            continue
        if isinstance(thing, type):
            lines += ["", *described(name, thing, module.__name__)]
        elif callable(thing):
            lines += function(name, thing.__doc__, module.__name__)
        else:
            lines.append(f"{name}: {type(thing).__name__}")
    text = "\n".join(lines) + "\n"
    return HEAD.replace("Union\n", "Union, overload\n" if "@overload" in text else "Union\n") + text


if __name__ == "__main__":
    Path(sys.argv[2]).write_text(stub_of(loaded(Path(sys.argv[1]))), encoding="utf-8")
