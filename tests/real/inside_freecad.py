# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inside FreeCAD: imports recipes and takes a picture at rest and one deformed, same camera.

The jobs are in the JSON file $SHEETMORPH_PICTURES; see take_pictures.py.
"""

import colorsys
import json
import os
import sys
import traceback

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from freecad.sheetmorph import api, objects
from pivy import coin
from PySide import QtCore

SIZE = (1600, 1200)
MARGIN = 1.15


def pictures(job: dict):
    """The pictures of one job; yields how many ms FreeCAD's event loop shall run."""
    document, assembly, shown = opened(job["recipe"], job)
    yield 400
    print(job["recipe"], assembly.Status, "unreached:", list(assembly.Unreached), flush=True)
    moved = api.deform(assembly)
    both = [points for p in shown for points in seen(api.rest_mesh(p)[0], moved[p.Name], job)]
    meshes = control_meshes(assembly, job)
    if job.get("control_meshes") == "single":
        both += [points for points, _ in meshes]
    aim(np.concatenate(both), job)
    drawn = [draw_wires(*mesh) for mesh in meshes]
    yield 300
    save(f"{job['out']}_after.png", job.get("size", SIZE))
    for node in drawn:
        scene().removeChild(node)
    if "first_recipe" in job:
        camera = view().getCamera()
        App.closeDocument(document.Name)
        document, assembly, _ = opened(job["first_recipe"], job)
        yield 400
        view().setCamera(camera)
    else:
        show_first(assembly, job)
        document.recompute()
    for mesh in control_meshes(assembly, job):
        draw_wires(*mesh)
    yield 300
    save(f"{job['out']}_before.png", job.get("size", SIZE))
    App.closeDocument(document.Name)


def opened(recipe: str, job: dict) -> tuple:
    """A new document with a recipe: the document, the morph and the parts that are shown."""
    document = App.newDocument("Pictures")
    assembly = api.import_recipe(document, recipe)
    parts = objects.parts(assembly)
    for number, part in enumerate(parts):
        dress(part, number, job)
    shown = [part for part in parts if part.Label in job.get("only", [p.Label for p in parts])]
    for part in set(parts) - set(shown):
        part.ViewObject.Visibility = False
    hide_regions(assembly, shown if job.get("regions", True) else [])
    document.recompute()
    return document, assembly, shown


def seen(rest: np.ndarray, moved: np.ndarray, job: dict) -> tuple:
    """What must be in the picture: all points (n, 3) at rest and moved, or those close at rest."""
    if "close" not in job:
        return rest, moved
    low, high = np.array(job["close"]).T
    return (moved[((rest[:, : len(low)] > low) & (rest[:, : len(low)] < high)).all(axis=1)],)


def show_first(assembly, job: dict) -> None:
    """What the left view shows: the parts at rest, or their form features with a rotation; with
    a `first_recipe` that one, deformed, instead."""
    for region in objects.regions(assembly):
        if "first" in job and region.Role == "form feature":
            api.set_rotation(region, job["first"])
        elif "first" not in job and region.Role == "handle":
            api.reset_motion(region)


def dress(part, number: int, job: dict) -> None:
    """Every part its own light colour; the primary stays sheet metal."""
    view = part.ViewObject
    if number:
        hue = (0.08 + 0.381966 * number) % 1.0
        view.ShapeColor = colorsys.hsv_to_rgb(hue, 0.38, 0.93)
    view.DisplayMode = job.get("display", "Shaded")
    view.LineColor = (0.35, 0.37, 0.4)
    view.CreaseAngle = job.get("crease", 30.0)


def hide_regions(assembly, shown: list) -> None:
    """Regions of parts that are not shown are not drawn."""
    for region in objects.regions(assembly):
        region.ViewObject.Visibility = region.Part in shown


def view():
    """The active 3D view."""
    return Gui.activeDocument().activeView()


def scene():
    """The root of the view's scene."""
    return view().getSceneGraph()


def aim(points: np.ndarray, job: dict) -> None:
    """Points a parallel camera so that it sees all points (n, 3) along the job's direction."""
    direction = np.array(job.get("direction", [-1.0, 1.2, -0.8]))
    direction /= np.linalg.norm(direction)
    right = np.cross(direction, job.get("up", [0.0, 0.0, 1.0]))
    right /= np.linalg.norm(right)
    size = job.get("size", SIZE)
    axes = np.array([right, np.cross(right, direction), -direction])
    vectors = [App.Vector(*axis) for axis in axes]
    view().setCameraType("Orthographic")
    view().setCameraOrientation(App.Rotation(*vectors, "ZXY"))
    seen = points @ axes.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    extent = high - low
    camera = view().getCameraNode()
    away = extent.max() + 10.0
    centre = axes.T @ ((low + high) / 2.0 + [0.0, 0.0, extent[2] / 2.0 + away])
    camera.position.setValue(*centre)
    camera.height.setValue(MARGIN * max(extent[1], extent[0] * size[1] / size[0]))
    camera.nearDistance.setValue(away / 2.0)
    camera.farDistance.setValue(2.0 * away + extent[2])
    camera.focalDistance.setValue(away + extent[2] / 2.0)


def control_meshes(assembly, job: dict) -> list:
    """The control meshes a job wants to see, in the document's pose: (vertices, triangles)."""
    wanted = job.get("control_meshes", [])
    if wanted == "all":
        wanted = objects.contacts(assembly)
    elif wanted == "single":
        wanted = [None]
    else:
        wanted = [c for c in objects.contacts(assembly) if c.Label in wanted]
    return [mesh for mesh in (api.control_mesh(assembly, one) for one in wanted) if mesh]


def draw_wires(points: np.ndarray, triangles: np.ndarray):
    """Wires of a mesh, put into the scene; the diagonals of its quads are left out."""
    node = coin.SoSeparator()
    material = coin.SoBaseColor()
    material.rgb = (0.25, 0.33, 0.62)
    style = coin.SoDrawStyle()
    style.lineWidth = 1.0
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(points), points.tolist())
    lines = coin.SoIndexedLineSet()
    index = [int(i) for edge in quad_edges(triangles) for i in (*edge, -1)]
    lines.coordIndex.setValues(0, len(index), index)
    for child in (light, material, style, coordinates, lines):
        node.addChild(child)
    scene().addChild(node)
    return node


def quad_edges(triangles: np.ndarray) -> np.ndarray:
    """Edges (k, 2) of quads that were cut: those that do not lie between triangles 2q and 2q+1."""
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2)
    ends = np.sort(ends.reshape(-1, 6, 2), axis=2)
    shared = []
    for quad in ends:
        pairs, times = np.unique(quad, axis=0, return_counts=True)
        shared.append(pairs[times == 2])
    cut = set(map(tuple, np.concatenate(shared).tolist()))
    edges = np.unique(ends.reshape(-1, 2), axis=0).tolist()
    return np.array([edge for edge in edges if tuple(edge) not in cut])


def save(path: str, size: tuple) -> None:
    """Saves what is seen."""
    view().saveImage(path, *size, "White")


def play(steps) -> None:
    """Runs the steps from timers; ends FreeCAD."""
    try:
        pause = next(steps)
    except StopIteration:
        os._exit(0)
    except Exception:  # noqa: B902 - whatever goes wrong must end FreeCAD
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)
    QtCore.QTimer.singleShot(pause, lambda: play(steps))


def all_jobs():
    """The jobs one after another."""
    Gui.getMainWindow().showMaximized()
    Gui.activateWorkbench("SheetMorphWorkbench")
    yield 500
    with open(os.environ["SHEETMORPH_PICTURES"], encoding="utf-8") as file:
        jobs = json.load(file)
    for job in jobs:
        yield from pictures(job)


if __name__ == "inside_freecad":
    QtCore.QTimer.singleShot(300, lambda: play(all_jobs()))
