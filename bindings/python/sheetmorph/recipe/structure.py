# SPDX-License-Identifier: LGPL-2.1-or-later
"""Validation against the JSON Schema of the recipe, with messages for users."""

from __future__ import annotations

import difflib
import json
from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any

import jsonschema

from ..base.errors import Fault
from ..base.packaged import packaged_json
from ..base.words import counted
from .places import place_of, subjects_at
from .pose import entries_of, is_plainly_sound
from .values import are_ids, bad_values, copied, depth_faults


def schema() -> dict[str, Any]:
    """Return the published JSON Schema of the recipe."""
    return packaged_json(__package__, "recipe.schema.json")


_IDS = {"$ref": "#/$defs/id"}


def _items(validator: Any, items: Any, instance: Any, parent: Any) -> Iterator[Any]:
    # A recipe can have millions of vertex ids, so they are checked together and not one by one.
    if items != _IDS or not are_ids(instance):
        yield from jsonschema.Draft202012Validator.VALIDATORS["items"](
            validator, items, instance, parent
        )


@cache
def _validator() -> Any:
    quick = jsonschema.validators.extend(jsonschema.Draft202012Validator, {"items": _items})
    return quick(schema())


@cache
def _pose_validator() -> Any:
    return _validator().evolve(schema={**schema(), "$ref": "#/$defs/pose", **_ONLY_REF})


def structural_faults(recipe: Any) -> tuple[list[Fault], Any]:
    """Return the schema faults, and a copy of the recipe without the faulty entries."""
    bad = list(bad_values(recipe, recipe, []))
    errors = _errors(_validator(), recipe, [path for path, _ in bad])
    places = [(list(error.absolute_path), _fault(recipe, error)) for error in errors] + bad
    sound = copied(recipe)
    for path, _ in places:
        _mark_unsound(sound, path)
    faults = [fault.about(*subjects_at(recipe, path)) for path, fault in places]
    return faults, _without_marked(sound)


@cache
def _where_validator() -> Any:
    return _validator().evolve(schema={**schema(), "$ref": "#/$defs/where", **_ANY_TYPE})


def where_faults(where: Any) -> list[Fault]:
    """Return the schema faults of a selector, or of a list of selectors."""
    bad = list(bad_values({"where": where}, where, ["where"]))
    errors = _errors(_where_validator(), where, [path[1:] for path, _ in bad])
    faults = [_fault({"where": where}, error, ["where"]) for error in errors]
    return faults + [fault for _, fault in bad]


def pose_faults(pose: Any) -> list[Fault]:
    """Return the schema faults of a pose; the usual valid form is recognised quickly."""
    if is_plainly_sound(pose):
        return []
    pose = entries_of(pose)
    if faults := depth_faults(pose):
        return faults
    bad = list(bad_values({"pose": pose}, pose, ["pose"]))
    errors = _errors(_pose_validator(), pose, [path[1:] for path, _ in bad])
    found = [
        (["pose", *error.absolute_path], _fault({"pose": pose}, error, ["pose"]))
        for error in errors
    ]
    return [fault.about(*subjects_at({}, path)) for path, fault in [*found, *bad]]


def faults_against(other: dict[str, Any], data: Any) -> list[Fault]:
    """Return the faults of other data against their own JSON Schema."""
    bad = list(bad_values(data, data, []))
    errors = _errors(jsonschema.Draft202012Validator(other), data, [path for path, _ in bad])
    return [_fault(data, error) for error in errors] + [fault for _, fault in bad]


def _errors(validator: Any, instance: Any, told: list[list[str | int]]) -> list[Any]:
    """Return the schema errors in order of their paths, except at paths that have a fault."""
    errors = sorted(validator.iter_errors(instance), key=lambda error: list(map(str, error.path)))
    errors = [error for error in errors if list(_innermost(error).absolute_path) not in told]
    misspelt = {(*e.absolute_path, key) for e in errors for key in _misspelt(e)}
    return [e for e in errors if not _is_missing(e, misspelt)]


def _misspelt(error: jsonschema.ValidationError) -> list[str]:
    """Return the keys that the user misspelt, as far as an error shows it."""
    if str(error.validator) != "additionalProperties":
        return []
    return _meant(error.instance, error.schema.get("properties", {}))


def _meant(entry: dict[str, Any], known: Iterable[str]) -> list[str]:
    """Return the known keys that unknown keys of an entry resemble."""
    names = list(known)
    unknown = [key for key in entry if key not in names]
    return [close for key in unknown for close in difflib.get_close_matches(key, names, 1)]


def has_misspelt_section(recipe: Any) -> bool:
    """Return whether a top-level key is misspelt, so that its section is missing."""
    return isinstance(recipe, dict) and bool(_meant(recipe, schema()["properties"]))


def _is_missing(error: jsonschema.ValidationError, keys: set[tuple[str | int, ...]]) -> bool:
    """Return whether an error reports one of the keys as missing."""
    is_required = str(error.validator) == "required"
    return is_required and (*error.absolute_path, _missing(error)) in keys


# Rules of the schema for a whole recipe, disabled for a pose.
_ONLY_REF: dict[str, Any] = {
    "properties": {},
    "required": [],
    "additionalProperties": True,
    "type": "object",
}


_ANY_TYPE: dict[str, Any] = {**_ONLY_REF, "type": ["object", "array"]}


def _fault(recipe: Any, error: jsonschema.ValidationError, root: list[str] | None = None) -> Fault:
    error = _innermost(error)
    path = [*(root or []), *error.absolute_path]
    if not path and str(error.validator) == "additionalProperties":
        known = error.schema.get("properties", {})
        path = [next(key for key in error.instance if key not in known)]
    where = place_of(recipe, path)
    what, todo = _explain(error)
    return Fault(where, what, todo)


def _innermost(error: jsonschema.ValidationError) -> jsonschema.ValidationError:
    """Return the error inside the anyOf alternative whose type the user chose."""
    kind: object = error.validator  # the stubs of jsonschema declare a class here
    if kind == "anyOf" and isinstance(error.instance, dict):
        inner = [e for e in error.context or () if str(e.validator) not in ("const", "type")]
        return inner[0] if inner else error
    return error


def _explain(error: jsonschema.ValidationError) -> tuple[str, str]:
    kind: object = error.validator
    value, limit = error.instance, error.validator_value
    wanted = error.schema.get("description", "something else")
    if kind == "required":
        missing = _missing(error)
        hint = error.schema.get("properties", {}).get(missing, {}).get("description", "")
        return f'the key "{missing}" is missing', f"add it{': ' + hint if hint else ''}"
    if kind == "additionalProperties":
        return _explain_unknown(error)
    if kind == "enum":
        return f"{_show(value)} is not {wanted}", f"use {' or '.join(map(_show, limit))}"
    if kind == "minItems" and len(value) == 0:
        return "the list is empty", f"give {wanted}"
    if kind in ("minItems", "maxItems"):
        return f"it has {counted(len(value), 'entry', 'entries')}", f"give {wanted}"
    return f"{_show(value)} is not valid", f"give {wanted}"


def _missing(error: jsonschema.ValidationError) -> str:
    """Return the missing key of an error.

    jsonschema raises one error for each key and names it only in its message: "'key' is a required
    property".
    """
    keys: list[str] = error.validator_value
    return next(k for k in keys if error.message == f"{k!r} is a required property")


def _explain_unknown(error: jsonschema.ValidationError) -> tuple[str, str]:
    known = list(error.schema.get("properties", {}))
    unknown = [key for key in error.instance if key not in known]
    close = difflib.get_close_matches(unknown[0], known, 1)
    todo = f'did you mean "{close[0]}"?' if close else f"known keys are {', '.join(known)}"
    return f"unknown key {', '.join(map(_show, unknown))}", todo


def _show(value: Any) -> str:
    text = json.dumps(value, ensure_ascii=False, default=str)
    return text if len(text) <= 40 else text[:37] + "..."


def _mark_unsound(sound: Any, path: list[str | int]) -> None:
    """Replace the list entry or top-level key at a path by None."""
    if not path or not isinstance(sound, dict) or path[0] not in sound:
        return
    section: Any = sound[path[0]]
    if len(path) > 1 and type(section) in (list, dict):
        section[path[1]] = None
    else:
        sound[path[0]] = None


def _without_marked(sound: Any) -> Any:
    """Remove the marked entries; list entries stay None, so that the others keep their index."""
    if not isinstance(sound, dict):
        return {}
    rest = {key: value for key, value in sound.items() if value is not None}
    for section in ("pose", "poses"):
        if isinstance(rest.get(section), dict):
            entries = rest[section].items()
            rest[section] = {key: value for key, value in entries if value is not None}
    return rest
