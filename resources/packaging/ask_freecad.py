# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run inside FreeCAD: writes what it is and which Python it embeds, for the shell to read.

The file named by SHEETMORPH_ANSWER gets one line a value: FreeCAD's version, the prefix of its
Python, that one's version, how the names of compiled modules must end, and where FreeCAD keeps
what is the user's, add-ons in its folder Mod.
"""

import os
import sys
import sysconfig

import FreeCAD

lines = [
    ".".join(FreeCAD.Version()[:3]),
    sys.base_prefix,
    "{}.{}".format(*sys.version_info),
    sysconfig.get_config_var("EXT_SUFFIX"),
    FreeCAD.getUserAppDataDir().rstrip("/"),
]
answer = os.environ["SHEETMORPH_ANSWER"]
with open(answer + ".part", "w", encoding="utf-8") as file:
    file.write("\n".join(lines) + "\n")
os.replace(answer + ".part", answer)
