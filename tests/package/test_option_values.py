# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options in any order mean the same, and one option means the same in every command."""

from __future__ import annotations

import argparse
import json
import random
from pathlib import Path
from typing import Any

import pytest

from sheetmorph.cli import main, parser
from sheetmorph.cli.parsing import STDOUT

DRAWN = 60
PARSER = parser()


def commands() -> dict[str, argparse.ArgumentParser]:
    return dict(PARSER._subparsers._group_actions[0].choices)


def value_of(action: argparse.Action) -> str:
    """A word that an option takes."""
    if action.choices:
        return str(next(iter(action.choices)))
    return {"view": "1,0,0", "runs": "0-3"}.get(action.dest, "7")


def words_of(action: argparse.Action, draw: random.Random) -> list[str]:
    """One way to write an option: its value, if it is optional, may be there or not."""
    name = draw.choice(action.option_strings)
    if action.nargs == 0:
        return [name]
    if action.nargs == "?":
        return draw.choice([[name], [f"{name}=value.json"], [name, "value.json"]])
    count = action.nargs if isinstance(action.nargs, int) else 1
    return [name, *[value_of(action)] * count]


def read(words: list[str]) -> dict[str, Any]:
    return vars(PARSER.parse_args(words))


@pytest.mark.parametrize("name", sorted(commands()))
def test_every_order_of_a_line_means_the_same(name: str):
    """With each value joined by "=" the line is clear to argparse itself: that is the answer."""
    command, draw = commands()[name], random.Random(name)
    options = [a for a in command._actions if a.option_strings and a.dest != "help"]
    places = [a for a in command._actions if not a.option_strings]
    optional = {option for a in options if a.nargs == "?" for option in a.option_strings}
    for _ in range(DRAWN):
        chosen = draw.sample(options, draw.randint(0, min(4, len(options))))
        chosen += [a for a in options if a.required and a not in chosen]
        groups = [words_of(a, draw) for a in chosen]
        if sum(len(group) == 2 and group[0] in optional for group in groups) and any(
            len(group) == 1 and group[0] in optional for group in groups
        ):
            continue  # such a line may be unclear, which another test is about
        if any(a.nargs == "*" for a in places) and any(
            g[0] in optional and not g[1:] for g in groups
        ):
            continue  # a bare --json takes the next word where no file is needed
        files = [a.choices[0] if a.choices else f"{k}.json" for k, a in enumerate(places)]
        clear = [["=".join(g)] if g[0] in optional and len(g) == 2 else g for g in groups]
        clear = [[f"{g[0]}={_const(options, g[0])}"] if g[0] in optional else g for g in clear]
        lines = [[word] for word in files] + groups
        draw.shuffle(lines)
        at = iter(files)
        line = [w for group in lines for w in ([next(at)] if group[0] in files else group)]
        assert read([name, *line]) == read([name, *files, *sum(clear, [])]), line


def _const(options: list[argparse.Action], name: str) -> Any:
    return next(a.const for a in options if name in a.option_strings)


@pytest.mark.parametrize("option", ["--repair", "--repa"])
def test_an_option_takes_no_argument_for_its_value(option: str):
    for line in (["run", "-o", "x", option, "r.json"], ["run", option, "r.json", "-ox"]):
        found = read(line)
        assert (found["recipe"], found["repair"]) == ("r.json", "standard")
    assert read(["run", "-o", "x", option, "crash", "r.json"])["repair"] == "crash"
    assert read(["run", "-o", "x", option, "--", "r.json"])["recipe"] == "r.json"
    assert read(["certify", "r.json", "--json", "out"])["folder"] == "out"
    assert read(["certify", "--json", "c.json", "r.json", "out"])["json"] == "c.json"


def test_a_line_with_two_meanings_is_refused(capsys: pytest.CaptureFixture[str]):
    with pytest.raises(SystemExit) as ended:
        read(["run", "-o", "x", "--repair", "a.json", "--json", "b.json"])
    assert ended.value.code == 2
    assert "--repair=a.json or --json=b.json" in capsys.readouterr().err


def test_an_option_of_one_name_means_the_same_everywhere():
    """A flag in one command is no path in another."""
    shapes: dict[str, dict[str, Any]] = {}
    for name, command in commands().items():
        for action in command._actions:
            for option in action.option_strings:
                shape = (action.nargs, type(action).__name__, action.const)
                shapes.setdefault(option, {})[name] = shape
    unlike = {option: found for option, found in shapes.items() if len(set(found.values())) > 1}
    assert unlike == {}
    for option in ("--json", "--report", "--quiet", "--force"):
        assert set(shapes[option]) == set(commands())


def test_json_is_the_result_in_a_file_or_on_stdout(
    folder: Path, capsys: pytest.CaptureFixture[str]
):
    def told(*line: str) -> str:
        assert main([*line]) == 0
        return capsys.readouterr().out

    run = ("run", "recipe.json", "-o", "out", "--quiet")
    assert json.loads(told(*run, "--json"))["parts"]
    assert "1 part written" in told(*run, "--json", "report.json")
    assert json.loads((folder / "report.json").read_text())["parts"]
    assert json.loads(told("certify", "recipe.json", "out", "--json"))["passed"]
    assert "certified" in told("certify", "recipe.json", "--json", "proof.json", "out")
    assert json.loads((folder / "proof.json").read_text())["passed"]
    assert json.loads(told("check", "--json", "recipe.json"))["valid"]
    assert "valid" in told("check", "recipe.json", "--json", "nothing.json")
    assert not (folder / "nothing.json").exists()
    assert main([*run, "--json", "a.json", "--report", "b.json"]) == 2
    assert "leave out one" in capsys.readouterr().err
    assert STDOUT == "-" and not (folder / STDOUT).exists()


STUDY = {
    "sheetmorph_study": 1,
    "recipe": "recipe.json",
    "parameters": {"lift": {"path": "pose.tip.translation[2]", "values": [1, 2]}},
    "measure": {"tip": {"position": "tip"}},
}
# A command, and a key of its result.
RESULTS = [
    (["doctor", "plate.obj"], "files"),
    (["doctor"], "installation"),
    (["find", "plate.obj"], "features"),
    (["init", "plate.obj"], "parts"),
    (["init", "plate.obj", "-o", "new.toml"], "parts"),
    (["resolve", "recipe.json"], "parts"),
    (["flatten", "plate.obj"], "blanks"),
    (["copy", "plate.obj", "-o", "same"], "files"),
    (["schema", "study"], "properties"),
    (["show", "recipe.json", "-o", "new.png"], "files"),
    (["study", "study.json", "-o", "variants"], "runs"),
]


@pytest.mark.parametrize(("line", "key"), RESULTS)
def test_every_command_gives_its_result_as_json(
    line: list[str], key: str, folder: Path, capsys: pytest.CaptureFixture[str]
):
    (folder / "study.json").write_text(json.dumps(STUDY))
    assert main([*line, "--quiet", "--force", "--json", "result.json"]) == 0
    assert capsys.readouterr().out
    kept = json.loads((folder / "result.json").read_text())
    assert main([*line, "--quiet", "--force", "--json=-", "--report", "other.json"]) == 0
    assert json.loads(capsys.readouterr().out).keys() == kept.keys() and kept[key]
    assert json.loads((folder / "other.json").read_text()).keys() == kept.keys()
    assert main([*line, "--quiet", "--force", "--report", "-"]) == 0
    assert json.loads(capsys.readouterr().out).keys() == kept.keys()


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (["doctor", "--json", "plate.obj"], "name of a part"),
        (["doctor", "--force", "plate.obj", "--json", "plate.obj"], "name of a part"),
        (["find", "plate.obj", "-o", "new.json", "--json", "new.json"], "-o names it already"),
        (["copy", "plate.obj", "-o", "same", "--json", "recipe.json"], "did not write"),
        (["resolve", "recipe.json", "--force", "--json", "recipe.json"], "also reads it"),
        (["schema", "--json", "no/folder/a.json"], "its folder does not exist"),
        (["schema", "--json", "a.json", "--report", "b.json"], "leave out one"),
    ],
)
def test_a_result_is_written_over_no_input(
    line: list[str], message: str, folder: Path, capsys: pytest.CaptureFixture[str]
):
    before = {path: path.read_bytes() for path in folder.iterdir()}
    assert main(line) == 2
    error = capsys.readouterr().err
    assert message in error and error.count("\n") == 1
    assert {path: path.read_bytes() for path in folder.iterdir()} == before


def test_a_value_with_a_choice_is_no_file():
    found = read(["schema", "--json", "study"])
    assert (found["of"], found["json"]) == ("study", STDOUT)
    assert read(["completion", "--json", "zsh"])["shell"] == "zsh"


@pytest.mark.parametrize("name", sorted(commands()))
def test_a_help_page_has_one_sentence_and_an_example_that_is_understood(name: str):
    command = commands()[name]
    assert command.description.endswith(".") and ". " not in command.description
    example = command.epilog.removeprefix("Example: ") % {"prog": f"sheetmorph {name}"}
    assert read(example.split()[1:])["command"] == name
    assert f"\n    {name} " in PARSER.format_help()


def test_a_certificate_that_fails_is_printed_all_the_same(
    folder: Path, capsys: pytest.CaptureFixture[str]
):
    assert main(["run", "recipe.json", "-o", "out", "--quiet"]) == 0
    lines = (folder / "out" / "plate.obj").read_text().splitlines()
    (folder / "out" / "plate.obj").write_text("\n".join(pressed(line) for line in lines) + "\n")
    capsys.readouterr()
    assert main(["certify", "recipe.json", "out", "--json"]) == 3
    assert not json.loads(capsys.readouterr().out)["passed"]


def pressed(line: str) -> str:
    """A line of an OBJ file pressed along x: no hole stays round."""
    kind, *words = line.split(" ")
    if kind != "v":
        return line
    x, y, z = map(float, words)
    return f"v {0.5 * x!r} {y!r} {z!r}"
