# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the modules and the CAD worker link is what the licence in README.md is said for."""
import re
import subprocess
from pathlib import Path

import pytest
import sheetmorph

FOLDER = Path(sheetmorph.__file__).parent
BUILT = [*sorted(FOLDER.glob("*.so")), FOLDER / "sheetmorph-cad"]
# The system's own, and Highway (Apache-2.0), which asks the processor for its instructions.
SYSTEM = r"libstdc\+\+|libm|libgcc_s|libc|libgomp|ld-linux-x86-64|libhwy"
ALLOWED = {
    "_core": rf"({SYSTEM})\.so\.\d+",
    "sheetmorph-cad": rf"({SYSTEM}|libTK\w+)\.so[\d.]*",
    "_coin": rf"({SYSTEM}|libCoin)\.so[\w.]*",
}


@pytest.mark.parametrize("module", BUILT, ids=lambda path: path.name.split(".")[0])
def test_a_module_links_nothing_but_what_it_is_known_to(module):
    listed = subprocess.run(["readelf", "-d", module], capture_output=True, text=True, check=True)
    needed = re.findall(r"\(NEEDED\).*\[(.+)\]", listed.stdout)
    assert needed
    allowed = ALLOWED[module.name.split(".")[0]]
    assert [name for name in needed if not re.fullmatch(allowed, name)] == []


@pytest.mark.parametrize("module", BUILT[:-1], ids=lambda path: path.name.split(".")[0])
def test_no_module_loads_opencascade_into_the_process_that_imports_it(module):
    loaded = subprocess.run(["ldd", module], capture_output=True, text=True, check=True)
    assert "libc.so" in loaded.stdout and "libTK" not in loaded.stdout
