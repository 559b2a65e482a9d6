# SPDX-License-Identifier: LGPL-2.1-or-later
"""Named numbers of the kernel without a source in their comment."""
import re

# A number with a name: constexpr, in a file, a class or a function.
TYPES = (
    "double|float|long double|Real|int|std::size_t|std::ptrdiff_t|Eigen::Index|std::chrono::\\w+"
)
NUMBER = re.compile(
    rf"^[ \t]*(?:static |inline )*constexpr (?:static |inline )*(?:{TYPES}) "
    r"(?P<name>\w+)(?:\[\])? ?[={(](?P<value>[^;]*);(?P<tail>[^\n]*)$",
    re.M,
)
COMMENT = re.compile(r"//!?<? ?(.*)")
# A sentence or a clause that begins with the source: where the value comes from ("From geometry:",
# "mm, from the reader"), a measurement, or what kind of choice it is. A "distance from a plane" is
# none.
SOURCE = re.compile(r"(?:^|[.;,(:] )(?:from|chosen|measured)\b|\bis from\b|\brecommend", re.I)
# Values that need none: other names, limits of the number format, and marks such as "none" (-1).
NO_NUMBER = re.compile(r"^[^0-9]*$|numeric_limits|^-[0-9]$|^0$")


def comment_of(lines: list[str], number: int) -> str:
    """Return the comment above line `number` (from 0), over other constants of one block.

    Constants without a blank line between them share the comment above the first one.
    """
    words: list[str] = []
    row = number - 1
    while row >= 0 and lines[row].strip():
        text = lines[row].strip()
        if text.startswith("//"):
            words.insert(0, COMMENT.match(text).group(1))
        elif words or "constexpr" not in text:
            break
        row -= 1
    return " ".join(words)


def numbers_without_source(text: str) -> list[str]:
    """Return the named numbers whose comment does not say where they come from."""
    lines = text.split("\n")
    faults = []
    for match in NUMBER.finditer(text):
        if NO_NUMBER.search(match["value"].strip()):
            continue
        line = text.count("\n", 0, match.start())
        last = text.count("\n", 0, match.end())
        beside = " ".join(re.findall(r"//(?:!<)? ?(.*)", "\n".join(lines[line : last + 1])))
        if not (SOURCE.search(comment_of(lines, line)) or SOURCE.search(beside)):
            faults.append(f"line {line + 1}: {match['name']}")
    return faults
