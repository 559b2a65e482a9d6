# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `completion`: a script that completes command lines in a shell."""

from __future__ import annotations

import argparse

from ..files.atomic import FileSet
from .arguments import parser
from .output import Outcome

# Files complete where no word fits. zsh reads the same script through its bashcompinit.
_BASH = """\
_sheetmorph()
{{
    local word="${{COMP_WORDS[COMP_CWORD]}}" found=""
    case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD-1]}}" in
{values}
    *) case "$COMP_CWORD-${{COMP_WORDS[1]}}-$word" in
        1-*) found="{commands}" ;;
{options}
        esac ;;
    esac
    COMPREPLY=($(compgen -W "$found" -- "$word"))
}}
complete -o bashdefault -o default -F _sheetmorph sheetmorph
"""
_ZSH = """\
autoload -Uz compinit bashcompinit
whence compdef >/dev/null || compinit
bashcompinit
"""


def execute(wanted: argparse.Namespace, _files: FileSet) -> Outcome:
    """Return the script of the shell."""
    commands = parser()._subparsers._group_actions[0]  # type: ignore[union-attr]
    assert isinstance(commands, argparse._SubParsersAction)
    if wanted.shell == "fish":
        lines = _fish(commands)
    else:
        lines = (_ZSH * (wanted.shell == "zsh") + _bash(commands)).splitlines()
    return Outcome(lines, {"shell": wanted.shell, "script": lines})


def _bash(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> str:
    values, options = [], []
    for name, command in commands.choices.items():
        words = " ".join(one.option_strings[-1] for one in command._actions if one.option_strings)
        options.append(f'        *-{name}--*) found="{words}" ;;')
        for action in command._actions:
            chosen = " ".join(map(str, action.choices or ()))
            places = action.option_strings or [name]
            values += [f'    "{name} {one}") found="{chosen}" ;;' for one in places if chosen]
    return _BASH.format(
        values="\n".join(values), options="\n".join(options), commands=" ".join(commands.choices)
    )


def _fish(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> list[str]:
    """Return one `complete` line for every command and option."""
    lines = []
    for entry in commands._get_subactions():
        start = f"complete -c sheetmorph -n __fish_use_subcommand -f -a {entry.dest}"
        lines.append(f"{start} -d {_quoted(entry.help)}")
    for name, command in commands.choices.items():
        start = f"complete -c sheetmorph -n '__fish_seen_subcommand_from {name}'"
        for action in command._actions:
            flags = "".join(
                f" -l {word[2:]}" if word.startswith("--") else f" -s {word[1:]}"
                for word in action.option_strings
            )
            way = " -r" if flags and action.nargs not in (0, "?") else ""
            if action.choices:
                words = _quoted(" ".join(map(str, action.choices)))
                way = f" {'-x' if flags else '-f'} -a {words}"
            if flags or way:
                lines.append(f"{start}{flags}{way} -d {_quoted(action.help)}")
    return lines


def _quoted(text: str | None) -> str:
    """Return a text in the quotes of fish."""
    plain = (text or "").replace("%%", "%").replace("\\", "\\\\").replace("'", "\\'")
    return f"'{plain}'"
