# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs clang-tidy over the kernel and the bindings: tidy.py BUILD

What passed is not looked at again until the file, a header it includes or the rules change.
"""
import hashlib
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
INCLUDE = re.compile(rb'^#include "([^"]+)"', re.MULTILINE)


def headers_of(source: Path, seen: set[Path]) -> set[Path]:
    """The headers of ours that a file includes, directly or not."""
    for name in INCLUDE.findall(source.read_bytes()):
        for folder in (ROOT / "core", source.parent):
            header = folder / name.decode()
            if header.is_file() and header not in seen:
                seen.add(header)
                headers_of(header, seen)
    return seen


def fingerprint(source: Path) -> str:
    """Changes when anything changes that decides what clang-tidy says about the file."""
    digest = hashlib.sha256((ROOT / ".clang-tidy").read_bytes())
    for path in [source, *sorted(headers_of(source, set()))]:
        digest.update(path.read_bytes())
    return digest.hexdigest()


def tidy(source: Path, build: Path) -> str:
    """What clang-tidy has to say about one file; empty if nothing."""
    stamp = build / "test" / "tidy" / fingerprint(source)
    if stamp.exists():
        return ""
    done = subprocess.run(
        ["clang-tidy", "-p", str(build), "--quiet", str(source)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        check=False,
    )
    if done.returncode == 0:
        stamp.parent.mkdir(parents=True, exist_ok=True)
        stamp.touch()
        return ""
    return (done.stdout or done.stderr).decode(errors="replace")


def main(build: Path) -> int:
    """Checks every compiled file of ours; 1 if one has faults, or none was found."""
    found = sorted((ROOT / "core").rglob("*.cpp")) + sorted((ROOT / "bindings").rglob("*.cpp"))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = [text for text in pool.map(lambda source: tidy(source, build), found) if text]
    print("".join(faults), f"clang-tidy: {len(found)} files, {len(faults)} with faults", sep="")
    return 1 if faults or not found else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
