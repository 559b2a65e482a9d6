# SPDX-License-Identifier: LGPL-2.1-or-later
"""The package says that it is typed, and has the types of its compiled modules beside it."""

from __future__ import annotations

import ast
import importlib.util
from pathlib import Path

import pytest

import sheetmorph
from sheetmorph import _core

FOLDER = Path(sheetmorph.__file__).parent
MAKER = Path(__file__).resolve().parents[2] / "bindings" / "stubs.py"


def stub() -> ast.Module:
    return ast.parse((FOLDER / "_core.pyi").read_text("utf-8"))


def classes() -> dict[str, ast.ClassDef]:
    return {node.name: node for node in stub().body if isinstance(node, ast.ClassDef)}


def functions(node: ast.ClassDef, name: str) -> list[ast.FunctionDef]:
    return [one for one in node.body if isinstance(one, ast.FunctionDef) and one.name == name]


def test_the_package_says_that_it_is_typed():
    assert (FOLDER / "py.typed").is_file()


def test_the_stub_has_every_name_of_the_compiled_module():
    body = stub().body
    told = {node.name for node in body if hasattr(node, "name")}
    told |= {node.target.id for node in body if isinstance(node, ast.AnnAssign)}
    public = {name for name in vars(_core) if not name.startswith("_")}
    assert public <= told and len(public) > 7


def test_the_stub_has_every_member_of_every_class():
    for name, node in classes().items():
        members = {one.name for one in node.body if isinstance(one, ast.FunctionDef)}
        public = {key for key in vars(getattr(_core, name)) if not key.startswith("_")}
        assert public <= members, name


def test_members_have_their_types():
    (face,) = functions(classes()["Neighbourhood"], "face")
    told = [ast.unparse(argument) for argument in face.args.args]
    assert told == ["self", "triangle: int", "max_angle: float"]
    assert ast.unparse(face.returns) == "NDArray[np.int32]"
    result = next(n for n in stub().body if getattr(n, "name", "") == "cured")
    assert ast.unparse(result.returns) == "CuredMesh"


def test_classes_that_were_named_before_they_were_known_have_their_names():
    (contacts,) = functions(classes()["Deformed"], "contacts")
    assert ast.unparse(contacts.returns) == "list[ContactFidelity]"


def test_what_is_set_has_its_type_and_what_takes_a_list_takes_a_tuple():
    setter = functions(classes()["Assembly"], "contacts")[1]
    assert ast.unparse(setter.args.args[1]) == "value: Sequence[Contact]"


def test_classes_that_nobody_makes_have_no_constructor():
    assert not functions(classes()["CuredMesh"], "__init__")
    assert functions(classes()["PickingTree"], "__init__")


@pytest.mark.parametrize(
    "told, wanted",
    [
        ("typing.SupportsFloat | typing.SupportsIndex", "float"),
        ("collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex]", "Sequence[int]"),
        ("numpy.typing.NDArray[numpy.int32]", "NDArray[np.int32]"),
        (
            'typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 2]", "flags.c"]',
            "NDArray[np.float64]",
        ),
        (
            "collections.abc.Sequence[typing.Annotated[collections.abc.Sequence[typing.SupportsInt"
            ' | typing.SupportsIndex], "FixedSize(4)"]]',
            "Sequence[Sequence[int]]",
        ),
        ("numpy.ndarray[numpy.float64[m, 3], flags.c_contiguous]", "NDArray[np.float64]"),
    ],
)
def test_types_are_those_of_a_stub_whatever_pybind11_made_them(told: str, wanted: str):
    spec = importlib.util.spec_from_file_location("stubs", MAKER)
    stubs = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(stubs)
    assert stubs.plain(told, "sheetmorph._core") == wanted
