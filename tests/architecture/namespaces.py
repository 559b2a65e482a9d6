# SPDX-License-Identifier: LGPL-2.1-or-later
"""One namespace a layer: which namespaces a C++ source opens, and which it uses as a whole."""
import re

from measures import NOT_CODE, blank

OPENED = re.compile(r"\bnamespace\s+([\w:]+)\s*\{")
TAKEN_WHOLE = re.compile(r"\busing\s+namespace\s+([\w:]+)")
# Others allow specialisations of their templates there; Highway has one for each instruction set.
OF_OTHERS = {"std", "Eigen", "HWY_NAMESPACE"}


def namespace_of(layer: str) -> str:
    """`sheetmorph::mesh`; the types of `base` are everywhere, in plain `sheetmorph`."""
    return "sheetmorph" if layer == "base" else f"sheetmorph::{layer}"


def code_of(text: str) -> str:
    """A source without comments and strings."""
    return NOT_CODE.sub(blank, text)


def kernel_faults(layer: str, text: str) -> list[str]:
    """The namespaces that a kernel source opens or uses as a whole although it may not."""
    code, own = code_of(text), namespace_of(layer)
    opened = OPENED.findall(code)
    faults = [] if own in opened else [f"does not open {own}"]
    faults += [f"opens {name}" for name in opened if name not in OF_OTHERS | {own}]
    return faults + [f"uses all of {name}" for name in TAKEN_WHOLE.findall(code)]


def header_faults(text: str) -> list[str]:
    """The namespaces that a header uses as a whole, and with it whoever includes it."""
    return [f"uses all of {name}" for name in TAKEN_WHOLE.findall(code_of(text))]


def helper_faults(layer: str, text: str) -> list[str]:
    """The namespaces of a test or its helpers that lie outside those of the tested layer."""
    own = namespace_of(layer)
    return [
        f"opens {name}"
        for name in OPENED.findall(code_of(text))
        if name not in OF_OTHERS and not f"{name}::".startswith(f"{own}::")
    ]
