# SPDX-License-Identifier: LGPL-2.1-or-later
"""The script of `./sheetmorph run`: FreeCAD with the workbench and an example ready to move.

With SHEETMORPH_SHOWCASE_OUT=<folder> it runs without a user. It moves the handle through the panel
and writes before.png, after.png and the deformed meshes. FreeCAD then ends with status 0, or with 1
and the reason on stderr.
"""

import os
import sys
import traceback

import FreeCAD as App
import FreeCADGui as Gui
from freecad.sheetmorph import api, paths
from freecad.sheetmorph.qt import QtCore, QtGui, QtWidgets

EXAMPLE = "door_mirror"
FRAMES = 12
# into the open side, from where all parts are visible
LINE_OF_SIGHT = App.Vector(-0.35, -0.85, -0.3)
FAULTS = (
    ArithmeticError,
    AttributeError,
    LookupError,
    OSError,
    RuntimeError,
    TypeError,
    ValueError,
)
PATIENCE = 200_000  # ms until a run without a user is aborted


class Showcase:
    """The steps of the showcase, run by timers so that FreeCAD's event loop is never blocked."""

    def __init__(self, folder: str):
        """Prepare the steps; `folder` is for the pictures, empty with a user."""
        self._folder = folder
        self._steps = self._play() if folder else self._prepare()

    def start(self) -> None:
        """Start when FreeCAD is idle."""
        QtCore.QTimer.singleShot(300, self._next)
        if self._folder:
            QtCore.QTimer.singleShot(PATIENCE, lambda: leave("FreeCAD took too long."))

    def _next(self) -> None:
        """Run one step; any error must end a run without a user."""
        try:
            pause = next(self._steps)
        except StopIteration:
            if self._folder:
                leave("")
        except FAULTS as error:
            self._fail(error)
        else:
            QtCore.QTimer.singleShot(pause, self._next)

    def _fail(self, error: Exception) -> None:
        reason = "".join(traceback.format_exception(error))
        if self._folder:
            leave(reason)
        App.Console.PrintError(reason)

    def _prepare(self):
        """Open the example at rest, with its handle selected and the Move Handle panel open."""
        window = Gui.getMainWindow()
        window.showMaximized()
        Gui.activateWorkbench("SheetMorphWorkbench")
        for name in ("Report view", "Python console"):
            dock = window.findChild(QtWidgets.QDockWidget, name)
            if dock is not None:
                dock.hide()
        yield 500
        document = App.newDocument("DoorMirror")
        recipe = os.path.join(paths.examples(), EXAMPLE, "recipe.json")
        self.assembly = api.import_recipe(document, recipe)
        self.handle = next(o for o in self.assembly.Group if getattr(o, "Role", "") == "handle")
        self.goal = wanted_motion(self.handle)
        api.reset_motion(self.handle)
        document.recompute()
        document.clearUndos()
        look_along(Gui.activeDocument().activeView(), LINE_OF_SIGHT)
        Gui.SendMsgToActiveView("ViewFit")
        yield 700
        from freecad.sheetmorph.panels import move_panel

        self.panel = move_panel.open_panel(self.handle)
        yield 500
        Gui.SendMsgToActiveView("ViewFit")
        yield 700

    def _play(self):
        """Move the handle to the recipe's pose through the fields of the panel."""
        yield from self._prepare()
        self._picture("before")
        form = self.panel.form
        for frame in range(1, FRAMES + 1):
            for field, value in self.goal.items():
                if field.startswith("axis"):
                    getattr(form, field).setValue(value)
                else:
                    getattr(form, field).setValue(value * frame / FRAMES)
            yield 60
        yield 1200
        self._picture("after")
        self.panel.accept()
        yield 300
        api.write_parts(self.assembly, self._folder)

    def _picture(self, name: str) -> None:
        """Save a picture of the whole screen."""
        screen = QtGui.QGuiApplication.primaryScreen().grabWindow(0)
        path = os.path.join(self._folder, f"{name}.png")
        if not screen.save(path):
            raise OSError(f"The picture {path} could not be written.")


def look_along(view, direction) -> None:
    """Turn the camera to look along a direction, with z upwards on the screen."""
    right = direction.cross(App.Vector(0, 0, 1))
    up = right.cross(direction)
    view.setCameraOrientation(App.Rotation(right, up, -direction, "ZXY"))


def wanted_motion(handle) -> dict[str, float]:
    """Return the handle's motion in the recipe by field of the panel, mm and degrees."""
    fields = {f"translation_{c.lower()}": getattr(handle, f"Translation{c}").Value for c in "XYZ"}
    fields |= {f"axis_{c}": getattr(handle.Axis, c) for c in "xyz"}
    return fields | {"angle": handle.Angle.Value}


def leave(reason: str) -> None:
    """End FreeCAD immediately; a reason means failure."""
    print(reason, file=sys.stderr, flush=True)
    os._exit(1 if reason else 0)


# If the import by FreeCAD fails, it runs the script again as __main__, which must not go on.
if __name__ == "showcase_main":
    showcase = Showcase(os.environ.get("SHEETMORPH_SHOWCASE_OUT", ""))
    showcase.start()
elif __name__ == "__main__" and os.environ.get("SHEETMORPH_SHOWCASE_OUT"):
    leave("The showcase could not be loaded.")
