# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws set-up and frame times over the number of vertices."""

from __future__ import annotations

from pathlib import Path

from tables import Measured

SET_UP = {
    "set_up": "SheetMorph",
    "cgal_sre_arap_set_up": "CGAL SRE_ARAP",
    "cgal_arap_set_up": "CGAL ORIGINAL_ARAP",
}
FRAMES = {
    "live_frame": "SheetMorph, live",
    "substituted_frame": "SheetMorph, any pose",
    "exact_frame": "SheetMorph, exact",
    "cholmod_substitution": "CHOLMOD back-substitution",
    "cgal_sre_arap_iteration": "CGAL SRE_ARAP, one iteration",
    "cgal_arap_iteration": "CGAL ORIGINAL_ARAP, one iteration",
}


def draw(found: dict[str, dict[int, Measured]], path: Path) -> None:
    """Two double logarithmic plots side by side, as a PNG."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(1, 2, figsize=(11.0, 4.2), constrained_layout=True)
    for axis, lines, title in zip(axes, (SET_UP, FRAMES), ("Set-up", "One frame")):
        for name, label in lines.items():
            sizes = sorted(found.get(name, {}))
            if sizes:
                vertices = [found[name][size].counters.get("vertices", size) for size in sizes]
                style = "-o" if label.startswith("SheetMorph") else "--s"
                times = [found[name][size].median for size in sizes]
                axis.loglog(vertices, times, style, label=label, markersize=4)
        axis.set_title(title)
        axis.set_xlabel("vertices")
        axis.set_ylabel("ms")
        axis.grid(True, which="major", alpha=0.3)
        axis.legend(fontsize=8, frameon=False)
    figure.savefig(path, dpi=90)
