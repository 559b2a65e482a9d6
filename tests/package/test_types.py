# SPDX-License-Identifier: LGPL-2.1-or-later
"""The package says that it is typed, and has the types of its compiled module beside it."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import sheetmorph
from sheetmorph import _core

FOLDER = Path(sheetmorph.__file__).parent


@pytest.fixture(scope="module")
def stub() -> ast.Module:
    return ast.parse((FOLDER / "_core.pyi").read_text("utf-8"))


def test_the_package_says_that_it_is_typed():
    assert (FOLDER / "py.typed").is_file()


def test_the_stub_has_every_name_of_the_compiled_module(stub: ast.Module):
    told = {node.name for node in stub.body if hasattr(node, "name")}
    told |= {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign)}
    public = {name for name in vars(_core) if not name.startswith("_")}
    assert public <= told and len(public) > 60


def test_the_stub_has_every_member_of_every_class_with_its_types(stub: ast.Module):
    classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
    for name, node in classes.items():
        members = {one.name for one in node.body if isinstance(one, ast.FunctionDef)}
        public = {key for key in vars(getattr(_core, name)) if not key.startswith("_")}
        assert public <= members, name
    face = next(one for one in classes["Neighbourhood"].body if getattr(one, "name", "") == "face")
    told = [ast.unparse(argument) for argument in face.args.args]
    assert told == ["self", "triangle: int", "max_angle: float"]
    assert ast.unparse(face.returns) == "NDArray[np.int32]"
    result = next(n for n in stub.body if getattr(n, "name", "") == "cured")
    assert ast.unparse(result.returns) == "CuredMesh"
