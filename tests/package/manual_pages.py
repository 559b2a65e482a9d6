# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads built HTML pages and the code blocks of their sources."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = ROOT / "resources" / "docs"
FENCE = re.compile(
    r"^(`{3,})(\S+)(?: (\w+))?\n((?::\w+:[^\n]*\n)*)\n?(.*?)^\1$", re.DOTALL | re.MULTILINE
)
CAPTION = re.compile(r"^:caption: (.+)$", re.MULTILINE)


@dataclass(frozen=True)
class Block:
    """A fenced block: its language, its text, and the file that its caption names ("" if none)."""

    language: str
    text: str
    file: str


def code_blocks(page: Path) -> list[Block]:
    """Return the code blocks of a page, in order; directives without code are left out."""
    found = []
    for _, kind, language, options, text in FENCE.findall(page.read_text("utf-8")):
        if kind.startswith("{") and kind != "{code-block}":
            continue
        caption = CAPTION.search(options)
        name = caption.group(1).strip() if caption else ""
        found.append(Block(language or kind, text, name))
    return found


@dataclass
class Page(HTMLParser):
    """The links, sources and anchors of one HTML page."""

    path: Path
    links: list[str] = field(default_factory=list)
    loaded: list[str] = field(default_factory=list)
    anchors: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        super().__init__()
        self.feed(self.path.read_text("utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Collect what a tag names."""
        named = {key: value or "" for key, value in attrs}
        self.anchors |= {named[key] for key in ("id", "name") if key in named}
        if tag == "a" and "href" in named:
            self.links.append(named["href"])
        if "src" in named:
            self.loaded.append(named["src"])
        if tag == "link" and named.get("rel") in ("stylesheet", "icon", "shortcut icon"):
            self.loaded.append(named.get("href", ""))


def pages_below(folder: Path) -> dict[Path, Page]:
    """Return all HTML pages below a folder, by path."""
    return {path.resolve(): Page(path) for path in sorted(folder.rglob("*.html"))}


def broken_links(pages: dict[Path, Page]) -> list[str]:
    """Return each link to a file or an anchor that does not exist, as `page: link`."""
    broken = []
    for path, page in pages.items():
        for link in [*page.links, *page.loaded]:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc or link in ("#", ""):
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            anchors = pages[target].anchors if target in pages else {parts.fragment}
            if not target.is_file() or (parts.fragment and parts.fragment not in anchors):
                broken.append(f"{path.name}: {link}")
    return broken
