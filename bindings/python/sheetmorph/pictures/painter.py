# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program that draws scenes with VTK on a virtual screen; `drawing` starts it.

It reads scenes from its standard input and writes PNG images to its standard output, each after its
length, until the input ends. It does not load the package, because that would take longer than a
picture.
"""

from __future__ import annotations

import os
import pickle
import select
import subprocess
import sys
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np

# These imports register the rendering back ends, although no name of them is used.
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkArrowSource
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

if TYPE_CHECKING:
    from ..base.arrays import Ints
    from .scene import Arrow, Colour, Scene, Sheet

_TEXT: Colour = (0.13, 0.17, 0.22)
_EDGE: Colour = (0.45, 0.49, 0.54)
_CREASE = 30.0  # degrees; sharper edges are not smoothed
_MARGIN = 1.12
_BAND = 56  # pixels for texts, above and below the parts
_SHADES = 256
_SECONDS_TO_START = 20.0


def paint(scene: Scene, window: Any) -> bytes:
    """Draw a scene and return it as PNG."""
    renderer = vtkRenderer()
    window.SetSize(*scene.size)
    window.AddRenderer(renderer)
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetBackground2(0.88, 0.91, 0.94)
    renderer.GradientBackgroundOn()
    table = _table(scene)
    for sheet in scene.sheets:
        for actor in _actors(sheet, table):
            renderer.AddActor(actor)
    size = _size(scene)
    before = _layer_before(renderer, window)
    for arrow in scene.arrows:
        before.AddActor(_arrow(arrow, size))
    _look(renderer, scene, _bounds([renderer, before]))
    _write_texts(renderer, scene, table)
    window.Render()
    found = _png(window)
    for layer in (renderer, before):
        window.RemoveRenderer(layer)
    return found


def _window() -> Any:
    """Return a window for all scenes; to open one for each takes longer than to draw them."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    return window


def _png(window: Any) -> bytes:
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.ShouldRerenderOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.WriteToMemoryOn()
    writer.Write()
    return bytes(memoryview(writer.GetResult()))


def _layer_before(renderer: Any, window: Any) -> Any:
    """Return a renderer in front of all sheets, with the same camera."""
    before = vtkRenderer()
    window.SetNumberOfLayers(2)
    before.SetLayer(1)
    before.SetActiveCamera(renderer.GetActiveCamera())
    window.AddRenderer(before)
    return before


def _bounds(renderers: list[Any]) -> list[float]:
    """Return the least and largest x, y, z of everything drawn."""
    bounds = np.array([renderer.ComputeVisiblePropBounds() for renderer in renderers])
    bounds = bounds[bounds[:, 0] <= bounds[:, 1]]
    if not len(bounds):
        return [-1.0, 1.0] * 3
    low, high = bounds[:, ::2].min(axis=0), bounds[:, 1::2].max(axis=0)
    found: list[float] = np.column_stack([low, high]).ravel().tolist()
    return found


def _table(scene: Scene) -> Any:
    """Return the colour table of the values."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(_SHADES)
    places = np.linspace(0.0, 1.0, len(scene.ramp))
    for k, share in enumerate(np.linspace(0.0, 1.0, _SHADES)):
        shade = [np.interp(share, places, channel) for channel in zip(*scene.ramp)]
        table.SetTableValue(k, *shade, 1.0)
    table.SetTableRange(*scene.span)
    return table


def _actors(sheet: Sheet, table: Any) -> list[Any]:
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(sheet.points, np.float64), deep=True))
    found = []
    if len(sheet.triangles):
        found.append(_faces(sheet, points, table))
    if sheet.lines is not None and len(sheet.lines):
        data = vtkPolyData()
        data.SetPoints(points)
        data.SetLines(_cells(sheet.lines))
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(data)
        _lift(mapper)
        actor = _coloured(mapper, sheet.colour)
        actor.GetProperty().SetLineWidth(4.0)
        actor.GetProperty().LightingOff()
        found.append(actor)
    return found


def _faces(sheet: Sheet, points: Any, table: Any) -> Any:
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(_cells(sheet.triangles))
    if sheet.values is not None:
        of = data.GetCellData() if sheet.is_by_face else data.GetPointData()
        of.SetScalars(numpy_to_vtk(np.ascontiguousarray(sheet.values, np.float64), deep=True))
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SetFeatureAngle(_CREASE)
    normals.SplittingOn()
    normals.ConsistencyOff()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.SetScalarVisibility(sheet.values is not None)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    actor = _coloured(mapper, sheet.colour)
    if sheet.has_edges:
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetEdgeColor(*_EDGE)
    return actor


def _lift(mapper: Any) -> None:
    """Draw lines in front of the sheet on which they lie."""
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-4.0, -4.0)


def _cells(rows: Ints) -> Any:
    """Return cells of the point indices in rows (m, k); indices below 0 are left out."""
    whole = np.column_stack([(rows >= 0).sum(axis=1), rows]).astype(np.int64).ravel()
    cells = vtkCellArray()
    cells.SetCells(len(rows), numpy_to_vtkIdTypeArray(whole[whole >= 0], deep=True))
    return cells


def _coloured(mapper: Any, colour: Colour) -> Any:
    actor = vtkActor()
    actor.SetMapper(mapper)
    looks = actor.GetProperty()
    looks.SetColor(*colour)
    looks.SetAmbient(0.35)
    looks.SetDiffuse(0.75)
    looks.SetSpecular(0.15)
    return actor


def _size(scene: Scene) -> float:
    """Return the diagonal of the scene, mm."""
    points = [sheet.points for sheet in scene.sheets if len(sheet.points)]
    if not points:
        return 1.0
    whole = np.concatenate(points)
    return float(np.linalg.norm(np.ptp(whole, axis=0))) or 1.0


def _arrow(arrow: Arrow, size: float) -> Any:
    start, end = np.asarray(arrow.start, float), np.asarray(arrow.end, float)
    length = float(np.linalg.norm(end - start))
    shape = vtkArrowSource()
    thickness = min(0.25, 0.006 * size / max(length, 1e-300))
    shape.SetShaftRadius(thickness)
    shape.SetTipRadius(2.6 * thickness)
    shape.SetTipLength(min(0.5, 8.0 * thickness))
    shape.SetShaftResolution(24)
    shape.SetTipResolution(24)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(shape.GetOutputPort())
    actor = _coloured(mapper, arrow.colour)
    along = (end - start) / max(length, 1e-300)
    turn = np.cross([1.0, 0.0, 0.0], along)
    place = vtkTransform()
    place.Translate(*start)
    angle = np.degrees(np.arctan2(np.linalg.norm(turn), along[0]))
    axis = turn if np.linalg.norm(turn) > 1e-12 else np.array([0.0, 0.0, 1.0])
    place.RotateWXYZ(angle, *axis)
    place.Scale(length, length, length)
    actor.SetUserTransform(place)
    return actor


def _look(renderer: Any, scene: Scene, bounds: list[float]) -> None:
    renderer.ResetCamera(bounds)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    view = np.asarray(scene.view, float)
    middle = np.asarray(camera.GetFocalPoint())
    camera.SetPosition(*(middle + view / np.linalg.norm(view)))
    upright = abs(view[2]) < 0.999 * np.linalg.norm(view)
    camera.SetViewUp(*((0.0, 0.0, 1.0) if upright else (0.0, 1.0, 0.0)))
    renderer.ResetCamera(bounds)
    _fit(renderer, scene)
    renderer.ResetCameraClippingRange(bounds)


def _fit(renderer: Any, scene: Scene) -> None:
    """Fit the view to the visible points, not to their bounding sphere."""
    ends = [np.array([a.start, a.end], float) for a in scene.arrows]
    points = [s.points for s in scene.sheets if len(s.points)] + ends
    if not points:
        return
    camera = renderer.GetActiveCamera()
    matrix = camera.GetViewTransformMatrix()
    turn = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(3)])
    seen = np.concatenate(points) @ turn[:, :3].T + turn[:, 3]
    low, high = seen.min(axis=0), seen.max(axis=0)
    middle = 0.5 * (low + high)
    shift = turn[:2, :3].T @ middle[:2]
    for get, put in (
        (camera.GetFocalPoint, camera.SetFocalPoint),
        (camera.GetPosition, camera.SetPosition),
    ):
        put(*(np.asarray(get()) + shift))
    width, height = scene.size
    half = 0.5 * (high - low)
    has_texts = bool(scene.title or scene.legend or scene.values)
    free = height - 2 * _BAND if has_texts else height
    camera.SetParallelScale(_MARGIN * height * max(half[1] / free, half[0] / width, 1e-9))


def _write_texts(renderer: Any, scene: Scene, table: Any) -> None:
    height = scene.size[1]
    if scene.title:
        renderer.AddActor2D(_text(scene.title, (18, height - 36), 20))
    for row, (name, colour) in enumerate(scene.legend.items()):
        y = 16 + 24 * (len(scene.legend) - 1 - row)
        square = _text("    ", (18, y), 16)
        square.GetTextProperty().SetBackgroundColor(*colour)
        square.GetTextProperty().SetBackgroundOpacity(1.0)
        renderer.AddActor2D(square)
        renderer.AddActor2D(_text(name, (46, y), 16))
    if scene.values:
        bar = vtkScalarBarActor()
        bar.SetLookupTable(table)
        bar.SetNumberOfLabels(5)
        bar.UnconstrainedFontSizeOn()
        style = bar.GetLabelTextProperty()
        style.SetColor(*_TEXT)
        style.SetFontSize(14)
        style.ItalicOff()
        style.ShadowOff()
        style.BoldOff()
        bar.SetLabelFormat("%.3g")
        bar.SetOrientationToHorizontal()
        bar.SetPosition(0.33, 12 / height)
        bar.SetWidth(0.34)
        bar.SetHeight(44 / height)
        renderer.AddActor2D(bar)
        renderer.AddActor2D(_text(scene.values, (0.69 * scene.size[0], 16), 16))


def _text(text: str, place: tuple[float, float], size: int) -> Any:
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.SetPosition(*place)
    style = actor.GetTextProperty()
    style.SetFontSize(size)
    style.SetColor(*_TEXT)
    return actor


def _start_screen() -> subprocess.Popen[bytes]:
    """Start a virtual screen, which ends with the last program on it, and name it to VTK."""
    reading, writing = os.pipe()
    command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1600x1200x24", "-terminate"]
    server = subprocess.Popen(
        [*command, "-nolisten", "tcp"],
        pass_fds=[writing],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    os.close(writing)
    is_ready = bool(select.select([reading], [], [], _SECONDS_TO_START)[0])
    with os.fdopen(reading) as answer:
        number = answer.readline().strip() if is_ready else ""
    if not number:
        server.kill()
        raise SystemExit("no virtual screen starts; check that Xvfb works")
    os.environ["DISPLAY"] = f":{number}"
    return server


def _serve(scenes: BinaryIO, images: BinaryIO) -> None:
    window = _window()
    while head := scenes.read(8):
        image = paint(pickle.loads(scenes.read(int.from_bytes(head, "little"))), window)
        images.write(len(image).to_bytes(8, "little") + image)
        images.flush()


def main() -> None:
    """Draw scenes until the input ends."""
    images = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what VTK prints must not get between the images
    server = _start_screen()
    try:
        _serve(sys.stdin.buffer, images)
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    main()
