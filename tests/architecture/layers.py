# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arrows between the layers as functions from a source text to its faults."""
import ast
import re

BELOW_ASSEMBLY = {"base", "numerics", "fitting", "mesh"}
MAY_INCLUDE = {
    "base": {"base"},
    "numerics": {"base", "numerics"},
    "fitting": {"base", "numerics", "fitting"},
    "mesh": {"base", "numerics", "fitting", "mesh"},
    "forms": BELOW_ASSEMBLY | {"forms"},
    "pick": {"base", "mesh", "pick"},
    "repair": {"base", "fitting", "mesh", "repair"},
    "surface": BELOW_ASSEMBLY | {"forms", "surface"},
    "volume": BELOW_ASSEMBLY | {"volume"},
    "recognise": BELOW_ASSEMBLY | {"recognise"},
    "cad": BELOW_ASSEMBLY | {"cad"},
    "assembly": BELOW_ASSEMBLY | {"forms", "surface", "volume", "recognise", "cad", "assembly"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]', re.MULTILINE)
# Python, Qt, Coin and FreeCAD; output and files, which the kernel leaves to its callers.
FOREIGN_HEADER = re.compile(r"^(Python\.h|pybind11/|Inventor/|Q[A-Z]|Qt|FreeCAD|App/|Gui/|Mod/)")
OUTPUT_HEADER = re.compile(r"^(iostream|fstream|cstdio|stdio\.h|filesystem|print)$")

GUI_MODULES = {"FreeCADGui", "PySide", "PySide2", "PySide6", "pivy"}
GUI_FOLDERS = {"views", "panels", "scene", "commands", "qt", "init_gui", "showcase"}
GUI_FOLDERS |= {"editing", "interaction"}
STEPS = re.compile(
    r"\.(openTransaction|commitTransaction|abortTransaction|closeActiveTransaction)\("
)
OBSERVERS = re.compile(r"\b(addDocumentObserver)\(")
MAY_OBSERVE = {"bridge/snapshots.py", "editing/watch.py", "panels/guide.py", "objects/watcher.py"}
MAY_OBSERVE |= {"interaction/finishing.py"}
FREECAD_MODULES = {"FreeCAD", "freecad", "Mesh", "MeshPart", "Part"}


def kernel_faults(layer: str, text: str) -> list[str]:
    """What a kernel source of `layer` includes although it may not."""
    faults = []
    for header in INCLUDE.findall(text):
        if header.startswith("sheetmorph/"):
            other = header.split("/")[1]
            if other not in MAY_INCLUDE[layer]:
                faults.append(f"{layer} includes {other} ({header})")
        elif FOREIGN_HEADER.match(header):
            faults.append(f"the kernel includes {header}")
        elif OUTPUT_HEADER.match(header) and layer != "cad":
            faults.append(f"the kernel reads or writes by itself ({header})")
    return faults


def imported_modules(text: str) -> list[str]:
    """Every module a Python source imports, anywhere in it; relative ones begin with a dot."""
    modules = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            modules += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            start = "." * node.level + (node.module or "")
            modules.append(start)
            joint = "" if start.endswith(".") else "."
            modules += [start + joint + alias.name for alias in node.names]
    return modules


def local_part(module: str) -> str:
    """`panels` for `..panels.x`, `.panels` and `freecad.sheetmorph.panels.x`; else nothing."""
    if module.startswith("."):
        return module.lstrip(".").split(".")[0]
    if module.startswith("freecad.sheetmorph."):
        return module.split(".")[2]
    return ""


def package_faults(text: str) -> list[str]:
    """What the Python package imports although it works without FreeCAD and without a GUI."""
    forbidden = GUI_MODULES | FREECAD_MODULES
    return [
        f"the package imports {module}"
        for module in imported_modules(text)
        if module.split(".")[0] in forbidden
    ]


def editing_faults(file: str, text: str) -> list[str]:
    """What a workbench source (`panels/x.py`) does although only the editing session may."""
    faults = []
    if file != "editing/transactions.py":
        faults += [f"{found} is for editing.transactions" for found in STEPS.findall(text)]
    if file not in MAY_OBSERVE:
        faults += [f"{found} is for editing.watch" for found in OBSERVERS.findall(text)]
    return faults


def workbench_faults(place: str, text: str) -> list[str]:
    """What a workbench source imports although its place (`api`, `panels`, ...) forbids it."""
    faults = []
    for module in imported_modules(text):
        top, local = module.split(".")[0], local_part(module)
        if place in ("api", "objects", "tools") and (top in GUI_MODULES or local in GUI_FOLDERS):
            faults.append(f"{place} imports the GUI ({module})")
        if place == "tools" and (top in FREECAD_MODULES - {"freecad"} or local == "bridge"):
            faults.append(f"tools import FreeCAD ({module})")
        if place != "scene" and (top == "pivy" or module.endswith("._coin")):
            faults.append(f"{place} touches Coin ({module}); only scene may")
        if place != "conversion" and top == "Mesh":
            faults.append(f"{place} builds FreeCAD meshes ({module}); only conversion may")
        if place != "qt" and top.startswith("PySide"):
            faults.append(f"{place} imports {module}; only qt may")
        if place == "panels" and top in ("numpy", "scipy"):
            faults.append(f"panels hold geometry ({module})")
    return sorted(set(faults))
