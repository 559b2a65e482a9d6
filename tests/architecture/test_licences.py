# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nothing that only the GPL allows is compiled into the product or linked to it."""
import re
import subprocess
from pathlib import Path

import pytest
from source_tree import BINDINGS, KERNEL, ROOT, files, label

ONLY_FOR_TESTS = re.compile(r"cholmod|openblas|metis|suitesparse", re.IGNORECASE)
LICENCE = re.compile(r"SPDX-License-Identifier: ([\w.-]+)")


def sources_with_cgal():
    return [
        path for path in files(".cpp", ".h", below=KERNEL) if "#include <CGAL/" in path.read_text()
    ]


def licences(header: str) -> list[str]:
    return LICENCE.findall(Path(header).read_text(errors="replace"))


@pytest.mark.parametrize("source", sources_with_cgal(), ids=label)
def test_every_header_of_cgal_is_under_the_lgpl(source):
    """Those it includes by itself too: most of CGAL's packages are under the GPL."""
    if not Path("/usr/include/CGAL/version.h").is_file():
        pytest.skip("CGAL is not installed")
    listed = subprocess.run(
        ["g++", "-std=c++17", "-M", "-I", KERNEL.parent, "-I", "/usr/include/eigen3", source],
        capture_output=True,
        text=True,
        check=True,
    )
    headers = [name for name in listed.stdout.split() if "/CGAL/" in name]
    assert len(headers) > 1
    assert [name for name in headers if "GPL-3.0-or-later" in licences(name)] == []


def test_the_product_knows_no_other_sparse_solver():
    built = files(".cpp", ".h", below=KERNEL) + files(".cpp", ".h", below=BINDINGS)
    built += [ROOT / "CMakeLists.txt", ROOT / "core" / "CMakeLists.txt"]
    built += [BINDINGS / "CMakeLists.txt"]
    assert [label(path) for path in built if ONLY_FOR_TESTS.search(path.read_text())] == []
