# SPDX-License-Identifier: LGPL-2.1-or-later
"""Takes the pictures of the user guide in FreeCAD: before and after, side by side.

    /usr/bin/python3 tests/real/take_pictures.py <staged add-on> <folder> [name ...]

Needs a screen (DISPLAY; xvfb-run does) and ImageMagick. Pictures of the public data are left out
where the data is not at hand.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[1] / "resources" / "examples"
STEEP = [-1.0, 1.2, -1.1]
SIZE = "800x560"  # px, at most, of one of the two views

JOBS = {
    "mirror": {"example": "door_mirror", "crease": 45.0, "direction": [-0.6, 1.0, -0.35]},
    "mirror-back": {"example": "door_mirror", "crease": 45.0, "direction": [-0.6, -1.0, -0.35]},
    "mirror-control-mesh": {
        "example": "door_mirror", "crease": 45.0, "direction": [-0.6, 1.0, -0.35],
        "control_meshes": "single",
    },
    "panels": {"example": "body_panels", "crease": 45.0},
    "panels-control-mesh": {
        "example": "body_panels", "crease": 45.0, "control_meshes": "single",
    },
    "frame": {"example": "welded_frame", "direction": STEEP},
    "frame-control-meshes": {
        "example": "welded_frame", "direction": STEEP, "control_meshes": "all",
    },
    "lifted-strip": {
        "made": "strip", "direction": [-0.35, 1.0, -0.75], "first": "interpolated",
        "display": "Flat Lines",
    },
    "thin-lumps": {
        "made": "lumps", "direction": [-0.6, 1.0, -0.8], "regions": False,
    },
    "support": {"real": "support", "direction": [-1.0, 1.2, -0.6]},
    "support-below": {"real": "support", "direction": [-1.0, 1.0, 0.7]},
    "support-shelf": {"real": "shelf", "direction": STEEP, "only": ["W1000BOstat/1"]},
    "support-bracket": {
        "real": "bracket", "direction": [-1.0, 0.9, -0.3], "only": ["W1000BOstat/10"],
    },
    "wing": {"real": "wing", "crease": 45.0},
    "wing-end-plate": {"real": "end plate", "crease": 45.0, "only": ["f1_rw_end_plates/1"]},
    "thin-plate": {
        "real": "plate", "first_real": "plate as it comes", "direction": [-0.4, 1.2, -0.9],
        "crease": 1.0, "regions": False,
    },
    "thin-plate-holes": {
        "real": "plate", "first_real": "plate as it comes", "direction": [-0.1, 0.5, -1.0],
        "crease": 1.0, "regions": False, "close": [[-330.0, 30.0], [-110.0, 160.0]],
    },
    "box": {"real": "box"},
    "enclosure": {"real": "enclosure", "direction": [1.0, 1.2, -0.9], "up": [0.0, 1.0, 0.0]},
    "bar": {"real": "bar", "direction": STEEP},
    "cylinder": {"real": "cylinder", "direction": STEEP},
    "bumpy-plane": {"real": "bumpy_plane", "direction": STEEP},
}  # fmt: skip


def main(staged: Path, folder: Path, names: list[str]) -> None:
    """Takes the pictures with these names, all if there are none."""
    sys.path.insert(0, str(staged))
    with tempfile.TemporaryDirectory() as place:
        jobs = [job_of(name, Path(place)) for name in names or JOBS]
        jobs = [job for job in jobs if job]
        play(jobs, staged, Path(place))
        for job in jobs:
            compose(job, folder / f"{Path(job['out']).name}.png")


def job_of(name: str, place: Path) -> dict | None:
    """What inside_freecad.py is told about one picture; None if its data is not at hand."""
    job = {**JOBS[name], "out": str(place / name)}
    if "example" in job:
        return {**job, "recipe": str(EXAMPLES / job["example"] / "recipe.json")}
    job["recipe"] = str(place / f"{name}.json")
    if "made" in job:
        import lifted_strip
        import lumpy_plates  # lifted_strip makes the tests' helpers known

        written = {"strip": lifted_strip.written_strip, "lumps": lumpy_plates.written_plate}
        recipe = written[job["made"]](place)
        Path(job["recipe"]).write_text(json.dumps(recipe), encoding="utf-8")
        return job
    import recipes

    if recipes.data_folder() is None:
        print(f"{name}: {recipes.ABSENT}")
        return None
    Path(job["recipe"]).write_text(json.dumps(recipes.make(job["real"])), encoding="utf-8")
    if "first_real" in job:
        job["first_recipe"] = str(place / f"{name}-first.json")
        first = json.dumps(recipes.make(job["first_real"]))
        Path(job["first_recipe"]).write_text(first, encoding="utf-8")
    return job


def play(jobs: list[dict], staged: Path, place: Path) -> None:
    """Runs FreeCAD in a home of its own, with the add-on and without a start page."""
    home = place / "home"
    (home / "Mod").mkdir(parents=True)
    (home / "Mod" / "SheetMorph").symlink_to(staged.resolve())
    told = place / "jobs.json"
    told.write_text(json.dumps(jobs), encoding="utf-8")
    more = {"FREECAD_USER_HOME": str(home), "SHEETMORPH_PICTURES": str(told)}
    around = {**os.environ, **more, "QT_ENABLE_HIGHDPI_SCALING": "0"}
    quiet = {"env": around, "stdin": subprocess.DEVNULL, "check": True, "timeout": 600}
    settings = HERE.parent / "gui" / "settings.py"
    subprocess.run(["freecadcmd", str(settings)], stdout=subprocess.DEVNULL, **quiet)
    subprocess.run(["freecad", str(HERE / "inside_freecad.py")], **quiet)


def compose(job: dict, path: Path) -> None:
    """Puts before and after side by side, without the white around both."""
    views = [f"{job['out']}_{time}.png" for time in ("before", "after")]
    # Both lose the same margins, so that what stays put is seen at the same place.
    box = subprocess.run(
        ["convert", *views, "-compose", "darken", "-composite", "-bordercolor", "white"]
        + ["-border", "8", "-trim", "-format", "%wx%h%O", "info:"],
        check=True, capture_output=True, text=True,
    ).stdout  # fmt: skip
    subprocess.run(
        ["convert", *views, "-bordercolor", "white", "-border", "8", "-crop", box, "+repage"]
        + ["-bordercolor", "white", "-border", "12", "-resize", SIZE]
        + [
            "+append",
            "+dither",
            "-colors",
            "256",
            "-define",
            "png:compression-level=9",
            f"PNG8:{path}",
        ],
        check=True,
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:])
