# SPDX-License-Identifier: LGPL-2.1-or-later
"""Code that reads a message for what its error or fault could say as such.

A message holds names that users give, so its words prove nothing.
"""
import ast

TAKES_APART = {
    "endswith",
    "find",
    "findall",
    "finditer",
    "fullmatch",
    "index",
    "match",
    "partition",
    "removeprefix",
    "removesuffix",
    "rpartition",
    "rsplit",
    "search",
    "split",
    "splitlines",
    "startswith",
}
MESSAGES = {"failure", "fault", "message", "sentence", "warning", "why"}


def reading_faults(text: str) -> list[str]:
    """Places where a message is taken apart, or searched for words."""
    tree = ast.parse(text)
    joined = {id(part) for node in ast.walk(tree) for part in joined_words(node)}
    found: list[str] = []
    for holder in ast.walk(tree):
        if isinstance(holder, ast.ExceptHandler) and holder.name:
            errors = texts_of(holder)
            found += [line for node in ast.walk(holder) for line in taken(node, errors, joined)]
    found += [line for node in ast.walk(tree) for line in taken(node, MESSAGES, joined)]
    return sorted(set(found))


def texts_of(handler: ast.ExceptHandler) -> set[str]:
    """The names under which a handler has its error and what the error says."""
    named = {handler.name or ""}
    for node in ast.walk(handler):
        if isinstance(node, ast.Assign) and is_message(node.value, named):
            named |= {target.id for target in node.targets if isinstance(target, ast.Name)}
    return named


def is_message(node: ast.AST, names: set[str]) -> bool:
    """Whether an expression is one of some names, or `str` of it."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "str":
        return bool(node.args) and is_message(node.args[0], names)
    return isinstance(node, ast.Name) and node.id in names


def taken(node: ast.AST, names: set[str], allowed: set[int]) -> list[str]:
    """The place, if a node takes apart one of the messages."""
    is_taken = False
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        inner = [node.func.value, *node.args]
        is_taken = node.func.attr in TAKES_APART and any(is_message(one, names) for one in inner)
    if isinstance(node, ast.Compare) and isinstance(node.ops[0], (ast.In, ast.NotIn)):
        is_taken = is_message(node.comparators[0], names)
    return (
        [f"line {node.lineno}: a message is read"] if is_taken and id(node) not in allowed else []
    )


def joined_words(node: ast.AST) -> list[ast.AST]:
    """What stands in `" ".join(....split())`: one line made of several."""
    is_join = isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)
    if is_join and node.func.attr == "join" and isinstance(node.func.value, ast.Constant):
        return list(node.args)
    return []
