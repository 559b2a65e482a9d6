# SPDX-License-Identifier: LGPL-2.1-or-later
"""Started by ``./sheetmorph run``: FreeCAD with the workbench active and an example ready to move.

With SHEETMORPH_SHOWCASE_OUT=<folder> nobody is at the screen: the handle is moved through the
panel, before.png, after.png and the deformed meshes are written, and FreeCAD ends with status 0,
or with 1 and the reason on stderr.
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
LINE_OF_SIGHT = App.Vector(-0.35, -0.85, -0.3)  # into the open side: all parts are seen
FAULTS = (
    ArithmeticError,
    AttributeError,
    LookupError,
    OSError,
    RuntimeError,
    TypeError,
    ValueError,
)
PATIENCE = 200_000  # ms until a run without a user is given up


class Showcase:
    """Runs its steps from timers, so that FreeCAD's event loop is never blocked."""

    def __init__(self, folder: str):
        """``folder``: where the pictures go; empty if a user is at the screen."""
        self._folder = folder
        self._steps = self._play() if folder else self._prepare()

    def start(self) -> None:
        """Begins when FreeCAD is idle."""
        QtCore.QTimer.singleShot(300, self._next)
        if self._folder:
            QtCore.QTimer.singleShot(PATIENCE, lambda: leave("FreeCAD took too long."))

    def _next(self) -> None:
        """One step; whatever goes wrong must end a run without a user."""
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
        """The example at rest, its handle selected, the Move Handle panel open."""
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
        """Moves the handle to where the recipe wants it, by the fields of the panel."""
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
        """The whole screen as it is seen."""
        screen = QtGui.QGuiApplication.primaryScreen().grabWindow(0)
        path = os.path.join(self._folder, f"{name}.png")
        if not screen.save(path):
            raise OSError(f"The picture {path} could not be written.")


def look_along(view, direction) -> None:
    """Turns the camera so that it looks along a direction, z upwards on the screen."""
    right = direction.cross(App.Vector(0, 0, 1))
    up = right.cross(direction)
    view.setCameraOrientation(App.Rotation(right, up, -direction, "ZXY"))


def wanted_motion(handle) -> dict[str, float]:
    """Where the recipe wants the handle, by field of the panel: mm, degrees."""
    fields = {f"translation_{c.lower()}": getattr(handle, f"Translation{c}").Value for c in "XYZ"}
    fields |= {f"axis_{c}": getattr(handle.Axis, c) for c in "xyz"}
    return fields | {"angle": handle.Angle.Value}


def leave(reason: str) -> None:
    """Ends FreeCAD at once; a reason is a failure."""
    print(reason, file=sys.stderr, flush=True)
    os._exit(1 if reason else 0)


# FreeCAD imports the script; if that fails it runs it again as __main__, which must not go on.
if __name__ == "showcase_main":
    showcase = Showcase(os.environ.get("SHEETMORPH_SHOWCASE_OUT", ""))
    showcase.start()
elif __name__ == "__main__" and os.environ.get("SHEETMORPH_SHOWCASE_OUT"):
    leave("The showcase could not be loaded.")
