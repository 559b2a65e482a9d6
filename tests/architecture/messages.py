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
        right = node.comparators[0]
        is_list = isinstance(right, ast.Name) and not right.id.isupper()
        is_taken = is_message(right, names) or (is_list and is_message(node.left, {"text"}))
    return (
        [f"line {node.lineno}: a message is read"] if is_taken and id(node) not in allowed else []
    )


def joined_words(node: ast.AST) -> list[ast.AST]:
    """What stands in `" ".join(....split())`: one line made of several."""
    is_join = isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)
    if is_join and node.func.attr == "join" and isinstance(node.func.value, ast.Constant):
        return list(node.args)
    return []


def formatted_faults(text: str, classes: set[str]) -> list[str]:
    """Places where the handler of an error that has faults makes a text of the error."""
    handlers = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.ExceptHandler)]
    return [
        f"line {node.lineno}: the text of an error is used, not its faults"
        for handler in handlers
        if handler.name and handler.type is not None and caught(handler.type) & classes
        for node in ast.walk(handler)
        if is_text_of(node, handler.name)
    ]


def caught(node: ast.AST) -> set[str]:
    """The names of the classes that a handler catches."""
    named = [node, *getattr(node, "elts", [])]
    return {getattr(one, "attr", getattr(one, "id", "")) for one in named}


def is_text_of(node: ast.AST, name: str) -> bool:
    """Whether an expression is `str(name)`, or `name` in an f-string."""
    if isinstance(node, ast.FormattedValue):
        return isinstance(node.value, ast.Name) and node.value.id == name
    is_call = isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    return is_call and node.func.id == "str" and is_message(node, {name})


def bare_errors(text: str) -> list[str]:
    """Places that raise a ValueError or RuntimeError, which have no fault."""
    raised = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Raise)]
    calls = [node for node in raised if isinstance(node.exc, ast.Call)]
    names = {"ValueError", "RuntimeError"}
    return [f"line {node.lineno}: no fault" for node in calls if caught(node.exc.func) & names]
