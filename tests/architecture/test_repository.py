# SPDX-License-Identifier: LGPL-2.1-or-later
"""The top level, the version number and the description of the add-on say one thing."""
import re
import subprocess
import xml.etree.ElementTree as ElementTree

import pytest
from source_tree import IGNORED, ROOT, WORKBENCH, is_ignored

TOP_LEVEL = {
    *("CMakeLists.txt", "README.md", "LICENSE", "CHANGELOG.md", "CMakePresets.json", "package.xml"),
    *("CONTRIBUTING.md", "pyproject.toml"),
    *("sheetmorph", "core", "bindings", "Mod", "resources", "tests"),
}


def strangers(names: list[str]) -> list[str]:
    """Entries that do not belong to the top level; dotfiles and ignored folders may stand there."""
    kept = [name for name in names if not name.startswith(".") and not is_ignored(name)]
    return sorted(set(kept) - TOP_LEVEL)


def manifest() -> ElementTree.Element:
    """package.xml without its namespace."""
    root = ElementTree.parse(ROOT / "package.xml").getroot()
    for element in root.iter():
        element.tag = element.tag.rpartition("}")[2]
    return root


def test_nothing_else_stands_at_the_top():
    assert strangers([path.name for path in ROOT.iterdir()]) == []
    assert TOP_LEVEL - {path.name for path in ROOT.iterdir()} == set()


def test_a_stranger_at_the_top_is_noticed():
    assert strangers(["core", "setup.py", ".git", "build-dev"]) == ["setup.py"]
    assert IGNORED


def releases() -> list[tuple[str, str]]:
    """Version and date of the releases in the changelog, newest first."""
    text = (ROOT / "CHANGELOG.md").read_text()
    return re.findall(r"^## \[(\d+\.\d+\.\d+)\] - (\d{4}-\d\d-\d\d)$", text, re.MULTILINE)


def test_the_manifest_has_the_version_number_of_the_newest_release():
    root = manifest()
    assert (root.findtext("version"), root.findtext("date")) == releases()[0]


def test_the_package_has_the_version_number_of_the_manifest():
    text = (ROOT / "bindings" / "python" / "sheetmorph" / "base" / "version.py").read_text()
    assert f'\n__version__ = "{manifest().findtext("version")}"\n' in text


@pytest.mark.parametrize("name", ["CMakeLists.txt", "pyproject.toml"])
def test_a_build_reads_the_version_number_from_the_manifest(name):
    version = manifest().findtext("version")
    text = (ROOT / name).read_text()
    assert "package.xml" in text
    assert version not in text


def test_the_changelog_begins_with_what_is_not_released():
    titles = re.findall(r"^## \[(.+?)\]", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
    assert titles[0] == "Unreleased"
    assert titles[1:] == [version for version, _ in releases()]


def test_the_manifest_names_what_exists():
    root = manifest()
    assert (ROOT / root.findtext("icon")).is_file()
    assert (ROOT / root.find("license").get("file")).is_file()
    workbench = root.find("content/workbench")
    assert f"class {workbench.findtext('classname')}" in (WORKBENCH / "init_gui.py").read_text()


@pytest.mark.parametrize("script", ["sheetmorph", ".ci/run"])
def test_a_script_is_executable_and_parses(script):
    path = ROOT / script
    assert path.stat().st_mode & 0o111
    assert subprocess.run(["bash", "-n", str(path)], check=False).returncode == 0


@pytest.mark.parametrize(
    ("arguments", "code", "word"),
    [(["--help"], 0, "Usage"), ([], 2, "Usage"), (["fly"], 1, "no command 'fly'")],
)
def test_the_entry_script_answers(arguments, code, word):
    done = subprocess.run(
        [str(ROOT / "sheetmorph"), *arguments], capture_output=True, text=True, check=False
    )
    assert done.returncode == code
    assert word in done.stdout + done.stderr


@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md"])
def test_a_page_at_the_top_names_only_what_exists(page):
    text = (ROOT / page).read_text()
    named = re.findall(r"\b(?:resources|core|bindings|tests|Mod)/[\w./-]+", text)
    named += re.findall(r"\]\(([^):#]+)\)", text)
    assert len(named) > 3
    assert [name for name in named if not (ROOT / name.rstrip(".")).exists()] == []


@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md"])
def test_a_page_at_the_top_names_only_commands_that_exist(page):
    named = re.findall(r"^\./sheetmorph (\w+)", (ROOT / page).read_text(), re.MULTILINE)
    commands = re.findall(r"^  (\w+) ", (ROOT / "sheetmorph").read_text(), re.MULTILINE)
    assert len(named) > 1
    assert set(named) <= set(commands)
