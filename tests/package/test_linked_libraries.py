# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the modules link is what the licence in README.md is said for."""
import re
import subprocess
from pathlib import Path

import pytest
import sheetmorph

MODULES = sorted(Path(sheetmorph.__file__).parent.glob("*.so"))
# The system's own and Highway (Apache-2.0), which asks the processor for its instructions;
# GMP and MPFR (LGPL) are in _core for exact predicates.
SYSTEM = r"libstdc\+\+|libm|libgcc_s|libc|libgomp|ld-linux-x86-64|libhwy"
ALLOWED = {
    "_core": rf"({SYSTEM}|libgmp|libmpfr)\.so\.\d+",
    "_cad": rf"({SYSTEM}|libTK\w+)\.so[\d.]*",
    "_coin": rf"({SYSTEM}|libCoin)\.so[\w.]*",
}


@pytest.mark.parametrize("module", MODULES, ids=lambda path: path.name.split(".")[0])
def test_a_module_links_nothing_but_what_it_is_known_to(module):
    listed = subprocess.run(["readelf", "-d", module], capture_output=True, text=True, check=True)
    needed = re.findall(r"\(NEEDED\).*\[(.+)\]", listed.stdout)
    assert needed
    allowed = ALLOWED[module.name.split(".")[0]]
    assert [name for name in needed if not re.fullmatch(allowed, name)] == []
