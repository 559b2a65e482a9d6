# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shells complete command lines, and the launcher starts them from any folder."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import time
from pathlib import Path
from subprocess import PIPE

import pytest

import sheetmorph
from sheetmorph.cli import main, parser
from sheetmorph.cli.arguments import SHELLS

LAUNCHER = Path(sheetmorph.__file__).resolve().parents[3] / "bin" / "sheetmorph"
COMPLETE = """
COMP_WORDS=(%s)
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_sheetmorph
echo "${COMPREPLY[@]}"
"""


@pytest.fixture(params=SHELLS)
def script(request: pytest.FixtureRequest, capsys: pytest.CaptureFixture[str]) -> tuple[str, str]:
    """A shell and its script."""
    assert main(["completion", request.param]) == 0
    return request.param, capsys.readouterr().out


def test_every_command_and_option_is_in_the_script(script: tuple[str, str]):
    shell, text = script
    commands = parser()._subparsers._group_actions[0].choices
    options = {
        o[2:] for one in commands.values() for o in one._option_string_actions if o[1] == "-"
    }
    assert len(options) > 40
    sign = "-l " if shell == "fish" else "--"
    assert [name for name in commands if name not in text] == []
    assert [option for option in options if f"{sign}{option}" not in text] == []


def test_the_shell_accepts_its_script(script: tuple[str, str]):
    shell, text = script
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    done = subprocess.run([shell, "-n"], input=text, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("sheetmorph re", ["resolve"]),
        ("sheetmorph run recipe.json --pi", ["--pictures"]),
        ("sheetmorph find a.obj --split c", ["components"]),
        ("sheetmorph schema st", ["study"]),
        ("sheetmorph run rec", []),
    ],
)
def test_bash_completes_commands_options_and_values(line: str, words: list[str], capsys):
    main(["completion", "bash"])
    text = capsys.readouterr().out + COMPLETE % line
    done = subprocess.run(["bash"], input=text, capture_output=True, text=True, check=True)
    assert done.stdout.split() == words and done.stderr == ""


@pytest.mark.skipif(not LAUNCHER.is_file(), reason="the package is not in a build folder")
def test_the_launcher_runs_from_any_folder_and_through_a_link(tmp_path: Path):
    link = tmp_path / "sheetmorph"
    link.symlink_to(LAUNCHER)
    clean = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    for program in (LAUNCHER, link):
        done = subprocess.run(
            [program, "--version"], cwd=tmp_path, env=clean, capture_output=True, text=True
        )
        assert (done.returncode, done.stderr) == (0, "")
        assert done.stdout == f"sheetmorph {sheetmorph.__version__}\n"
    done = subprocess.run([link, "run", "--help"], env=clean, capture_output=True, text=True)
    assert "Example: sheetmorph run recipe.json -o deformed" in done.stdout


@pytest.mark.skipif(not LAUNCHER.is_file(), reason="the package is not in a build folder")
def test_an_interrupt_while_python_imports_prints_no_traceback(tmp_path: Path):
    clean = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    said = []
    for delay in (0.03 * k for k in range(1, 11)):
        with subprocess.Popen([LAUNCHER, "--help"], env=clean, stdout=PIPE, stderr=PIPE) as program:
            time.sleep(delay)
            program.send_signal(signal.SIGINT)
            said.append(program.communicate()[1].decode())
    # Before the launcher runs, Python itself answers with its own traceback.
    assert not any("sheetmorph/" in text or "numpy" in text for text in said), said
