# SPDX-License-Identifier: LGPL-2.1-or-later
"""A certificate as one self-contained HTML page with pictures, tables and histograms."""

from __future__ import annotations

import html
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..measuring.quality import areas, aspect, measured
from .measuring import Written

_WIDE, _HIGH = 420, 300
# Parts with more faces are drawn coarser, with every k-th face.
_MOST_FACES = 9000
_BLUE_TO_RED = np.array(
    [[49, 84, 163], [120, 190, 220], [250, 240, 190], [240, 140, 70], [165, 15, 40]]
)
_FEATURE_HEADS = (
    *("feature", "part", "edge error", "field width costs"),
    *("diameter before", "after", "roundness before", "after"),
)
_PART_HEADS = (
    *("part", "elements", "largest displacement, mm", "flipped", "newly failing"),
    *("thickness, mm", "material", "mass, kg", "area change, %", "time step before, µs", "after"),
    "mass added, share",
)
_QUALITY_HEADS = (
    *("part", "measure", "worst before", "after", "failing before", "after", "largest change"),
)
_WELD_HEADS = ["weld", "line", "gap before, mm", "to the other", "gap after, mm", "to the other",
               "change, mm"]  # fmt: skip
_JOINT_HEADS = (
    *("joint", "kind", "parts", "line", "gap before, mm", "after", "came apart by", "allowed"),
)
_MOST_JOINTS = 40
_STYLE = """
body { font: 14px/1.45 sans-serif; margin: 1.5em auto; max-width: 1320px; color: #222; }
h1 { font-size: 1.4em; } h2 { font-size: 1.1em; margin-top: 1.6em; }
table { border-collapse: collapse; font-size: 12px; }
th, td { padding: 2px 8px; text-align: right; border-bottom: 1px solid #ddd; }
td:first-child, th:first-child { text-align: left; }
.passed { color: #1b6e3c; } .failed { color: #b3261e; }
.row { display: flex; flex-wrap: wrap; gap: 10px; } figure { margin: 0; font-size: 12px; }
svg { background: #fafafa; border: 1px solid #ddd; } code { font-size: 11px; }
"""


def page_of(certificate: dict[str, Any], written: dict[str, Written]) -> str:
    """Return the page as HTML."""
    word = "passed" if certificate["passed"] else "failed"
    parts = [
        f"<h1>Certificate: <span class='{word}'>{word}</span></h1>",
        "<p>Measured on the written files, read back, by the criteria "
        f"<b>{_text(certificate['criteria']['name'])}</b>.</p>",
    ]
    if certificate["failures"]:
        rows = "".join(f"<li>{_text(text)}</li>" for text in certificate["failures"])
        parts.append(f"<ul class='failed'>{rows}</ul>")
    parts += [_pictures(written), _tables(certificate), _histograms(certificate)]
    body = "\n".join(parts)
    return (
        "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><title>Certificate</title>"
        f"<style>{_STYLE}</style></head><body>\n{body}\n</body></html>\n"
    )


def _text(value: object) -> str:
    return html.escape(str(value))


def _number(value: object) -> str:
    if value is None:
        return "–"
    return f"{value:.4g}" if isinstance(value, float) else _text(value)


def _table(title: str, heads: Sequence[str], rows: list[list[object]]) -> str:
    if not rows:
        return ""
    head = "".join(f"<th>{_text(one)}</th>" for one in heads)
    body = "".join(
        "<tr>" + "".join(f"<td>{_number(value)}</td>" for value in row) + "</tr>" for row in rows
    )
    return f"<h2>{_text(title)}</h2><table><tr>{head}</tr>{body}</table>"


def _tables(entry: dict[str, Any]) -> str:
    features = [
        [f["name"], f["part"], f["edge_error"], f["allowed"], rim.get("diameter_before"),
         rim.get("diameter_after"), rim.get("roundness_before"), rim.get("roundness_after")]
        for f in entry["features"]
        for rim in (f["rims"] or [{}])
    ]  # fmt: skip
    contacts = [
        [c["name"], c["gap_before"], c["gap_after"], c["worst_change"]] for c in entry["contacts"]
    ]
    parts = [
        [p["name"], p["elements"], p["largest_displacement"], p["flipped"], p["newly_failing"],
         p["thickness"], p["material"]["name"],
         None if p["mass"] is None else 1000.0 * p["mass"]["after_t"],
         100.0 * p["area_change"], _microseconds(p["time_step"]["before_ms"]),
         _microseconds(p["time_step"]["after_ms"]), p["time_step"]["added_mass_after"]]
        for p in entry["parts"]
    ]  # fmt: skip
    quality = [
        [p["name"], q["measure"], q["worst_before"], q["worst_after"], q["failing_before"],
         q["failing_after"], q["largest_change"]]
        for p in entry["parts"]
        for q in p["quality"]
    ]  # fmt: skip
    inside = [[p["part"], p["into"], p["vertices"], p["depth"]] for p in entry["penetrations"]]
    files = [[f["file"], f["sha256"]] for f in [*entry["inputs"], *entry["outputs"]]]
    tables = [
        _table("Form features, mm", _FEATURE_HEADS, features),
        _table("Contacts, mm", ["contact", "gap before", "after", "worst change"], contacts),
        _table("Parts", _PART_HEADS, parts),
        _table("Penetrations", ["part", "into", "vertices", "depth, mm"], inside),
        *(_deck(deck) for deck in entry["decks"]),
        *(_joints(joints) for joints in entry["joint_files"]),
        _table("Quality", _QUALITY_HEADS, quality),
        _table("Files", ["file", "SHA-256"], files),
    ]
    return "\n".join(tables)


def _microseconds(value: float | None) -> float | None:
    return None if value is None else 1000.0 * value


def _deck(deck: dict[str, Any]) -> str:
    joints, worst = deck["joints"], deck["joints"]["worst"]
    rows: list[list[object]] = [["nodes moved", deck["moved"]]]
    rows.append(["left behind", ", ".join(map(str, deck["left"][:20])) or "none"])
    rows.append(["joints", joints["count"]])
    if worst is not None:
        rows.append(["worst joint", f"{worst['card']} {worst['id']}, line {worst['line']}"])
        rows.append(["its change, mm", worst["change"]])
        rows.append(["allowed, mm", worst["limit"]])
    stale = [[s["card"], s["what"], s["count"], ", ".join(map(str, s["lines"][:8]))]
             for s in deck["stale"]]  # fmt: skip
    heads = ["card", "why", "how many", "lines"]
    tables = [_table(f"Deck {deck['file']}", ["what", ""], rows), _welds(deck)]
    return "".join([*tables, _table(f"Out of date in {deck['file']}", heads, stale)])


def _welds(deck: dict[str, Any]) -> str:
    """Return the table of a deck's welds, the largest gap changes first."""
    welds = deck["joints"]["welds"]

    def change(weld: dict[str, Any]) -> float:
        found: float = max(abs(b - a) for a, b in zip(weld["before"], weld["after"]))
        return found

    rows = [
        [f"{w['card']} {w['id']}", w["line"], *_two(w["before"]), *_two(w["after"]), change(w)]
        for w in sorted(welds, key=change, reverse=True)[:_MOST_JOINTS]
    ]
    title = f"Welds of {deck['file']}: {len(welds)}"
    title += f", the worst {_MOST_JOINTS}" if len(welds) > _MOST_JOINTS else ""
    return _table(title, _WELD_HEADS, rows) if rows else ""


def _two(gaps: list[float]) -> list[object]:
    return [*gaps, "none near"][:2]


def _joints(file: dict[str, Any]) -> str:
    """Return the table of a joint file, the worst joints first."""
    worst = sorted(file["joints"], key=lambda j: -float(j["change"] / max(j["limit"], 1e-30)))
    rows = [[j["joint"], j["kind"], ", ".join(j["parts"]), j["line"], j["gap_before"],
             j["gap_after"], j["change"], j["limit"]] for j in worst[:_MOST_JOINTS]]  # fmt: skip
    left = f", {len(file['left'])} without a sheet" if file["left"] else ""
    title = f"{file['format']} {file['file']}: {len(worst)} joints{left}"
    title += f", the worst {_MOST_JOINTS}" if len(worst) > _MOST_JOINTS else ""
    return _table(title, _JOINT_HEADS, rows)


def _histograms(entry: dict[str, Any]) -> str:
    figures = []
    for part in entry["parts"]:
        for quality in part["quality"]:
            found = quality["histogram"]
            if found and ("min" in quality or "max" in quality):
                figures.append(_histogram(f"{part['name']}: {quality['measure']}", found))
    shown = "".join(figures[:60])
    return f"<h2>Histograms: before (grey) and after (blue)</h2><div class='row'>{shown}</div>"


def _histogram(title: str, found: dict[str, list[float]]) -> str:
    most = max(1, *found["before"], *found["after"])
    bars = []
    for k, (one, two) in enumerate(zip(found["before"], found["after"])):
        for value, shift, colour in ((one, 0, "#bbb"), (two, 4, "#3154a3")):
            high = 70.0 * value / most
            bars.append(f"<rect x='{4 + 9 * k + shift}' y='{74 - high:.1f}' width='4' "
                        f"height='{high:.1f}' fill='{colour}'/>")  # fmt: skip
    low, high = found["edges"][0], found["edges"][-1]
    return (
        f"<figure><svg width='190' height='78'>{''.join(bars)}</svg><figcaption>{_text(title)}<br>"
        f"{low:.3g} … {high:.3g}</figcaption></figure>"
    )


def _pictures(written: dict[str, Written]) -> str:
    parts = list(written.values())
    if not parts:
        return ""
    moved = np.concatenate([part.places for part in parts])
    rest = np.concatenate([part.mesh.points for part in parts])
    first = np.cumsum([0, *(len(part.places) for part in parts)])
    faces = np.concatenate(
        [np.where(p.faces >= 0, p.faces + first[k], -1) for k, p in enumerate(parts)]
    )
    away = np.linalg.norm(moved - rest, axis=1)
    of_face = away[faces[:, :3]].mean(axis=1)
    one, two = measured(areas, rest, faces), measured(areas, moved, faces)
    stretch = np.divide(two, one, out=np.ones_like(one), where=one > 0.0) - 1.0
    shape = np.log(measured(aspect, moved, faces))
    view = _View(np.concatenate([rest, moved]))
    shown = [
        view.figure("before", rest, faces, None),
        view.figure("displacement, mm", moved, faces, of_face),
        view.figure("area change, share", moved, faces, stretch),
        view.figure("aspect ratio, logarithm", moved, faces, shape),
    ]
    return f"<div class='row'>{''.join(shown)}</div>"


class _View:
    """An axonometric view of all parts, along the direction that shows the largest area."""

    def __init__(self, points: Floats):
        self._middle = points.mean(axis=0)
        _, _, axes = np.linalg.svd(points[:: max(1, len(points) // 20000)] - self._middle, False)
        tilt = np.radians(35.0)
        self._right, up, out = axes
        self._up = np.cos(tilt) * up + np.sin(tilt) * out
        self._out = np.cross(self._right, self._up)
        flat = self._flat(points)
        low, high = flat.min(axis=0), flat.max(axis=0)
        size = np.maximum(high - low, 1e-9)
        self._scale = float(min((_WIDE - 20) / size[0], (_HIGH - 20) / size[1]))
        self._low, self._high = low, high

    def _flat(self, points: Floats) -> Floats:
        return np.stack(
            [(points - self._middle) @ self._right, (points - self._middle) @ self._up], 1
        )

    def figure(self, title: str, points: Floats, faces: Ints, values: Floats | None) -> str:
        """Return a picture of the faces, coloured by values (m,)."""
        step = -(-len(faces) // _MOST_FACES)
        chosen = faces[::step]
        flat = (self._flat(points) - self._low) * self._scale + 10.0
        depth = (points @ self._out)[chosen[:, :3]].mean(axis=1)
        low, high = (0.0, 1.0) if values is None else (float(values.min()), float(values.max()))
        shapes = []
        for k in np.argsort(depth).tolist():
            corners = [c for c in chosen[k].tolist() if c >= 0]
            place = " ".join(f"{flat[c, 0]:.1f},{_HIGH - flat[c, 1]:.1f}" for c in corners)
            value = None if values is None else (values[k * step] - low) / max(high - low, 1e-30)
            shapes.append(f"<polygon points='{place}' fill='{_colour(value)}'/>")
        told = title if values is None else f"{title}: {low:.3g} (blue) … {high:.3g} (red)"
        told += f"; every {step}th element" if step > 1 else ""
        return (
            f"<figure><svg width='{_WIDE}' height='{_HIGH}' stroke='#555' stroke-width='0.15'>"
            f"{''.join(shapes)}</svg><figcaption>{_text(told)}</figcaption></figure>"
        )


def _colour(value: float | None) -> str:
    if value is None:
        return "#c8ccd2"
    place = min(max(float(value), 0.0), 1.0) * (len(_BLUE_TO_RED) - 1)
    k = min(int(place), len(_BLUE_TO_RED) - 2)
    red, green, blue = _BLUE_TO_RED[k] + (place - k) * (_BLUE_TO_RED[k + 1] - _BLUE_TO_RED[k])
    return f"#{int(red):02x}{int(green):02x}{int(blue):02x}"
