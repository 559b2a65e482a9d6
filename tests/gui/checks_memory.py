# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much memory FreeCAD keeps of panels that were closed: of Move Handle with a frame in each, on
a part of 27,556 vertices, and of a task panel of FreeCAD without anything, to compare with."""

import ctypes
import gc
from collections import Counter

import FreeCADGui as Gui
from checks_idle import grid_part
from desk import clear_report_view, note, settled, until
from freecad.sheetmorph.panels.move_panel import open_panel
from PySide import QtGui
from scenes import regions

# The long one is imported by name where measurements take long.
__all__ = ["test_forty_openings_of_move_handle_keep_no_shape"]
SIDE = 166  # vertices in a row
FIRST = 20  # openings, until everything that is kept once is there
MOST = 5.0 / 300  # MB an opening: 300 may keep 5 MB; they keep 2.4
HEAP = "arena ordblks smblks hblks hblkhd usmblks fsmblks uordblks fordblks keepcost".split()


class Heap(ctypes.Structure):
    """What mallinfo2 of the C library tells, bytes."""

    _fields_ = [(name, ctypes.c_size_t) for name in HEAP]


def megabytes() -> float:
    """What is in use on the heap of the C library: what the system has given to this process rises
    and falls by more than what an opening keeps."""
    gc.collect()
    library = ctypes.CDLL(None)
    library.mallinfo2.restype = Heap
    heap = library.mallinfo2()
    return (heap.uordblks + heap.hblkhd) / 2.0**20


def resident() -> float:
    """MB that the system has given to this process, after the heap has returned what it can."""
    ctypes.CDLL(None).malloc_trim(0)
    with open("/proc/self/smaps_rollup", encoding="utf-8") as file:
        (line,) = [line for line in file if line.startswith("Anonymous:")]
    return int(line.split()[1]) / 1024.0


def kinds() -> Counter:
    """How many objects of each class Python has."""
    gc.collect()
    return Counter(type(one).__name__ for one in gc.get_objects())


class Empty:
    """A task panel of FreeCAD with a label."""

    def __init__(self):
        self.form = QtGui.QLabel("Nothing")
        self.form.setObjectName("empty")


def move_handle(count: int):
    """Opens Move Handle, waits for a frame in another pose, closes it."""
    form = open_panel(regions("handle")[0]).form  # found in the window, PySide keeps its widgets
    form.translation_z.setValue(6.0 + 0.01 * count)
    yield from until(lambda: form.status.text().startswith("Computed"), "a frame")


def empty_panel(_count: int):
    """Opens a panel without anything."""
    Gui.Control.showDialog(Empty())
    yield from until(Gui.Control.activeDialog, "the panel")


def openings(opened, first: int, last: int):
    """Opens and closes a panel again and again."""
    for count in range(first, last):
        yield from opened(count)
        Gui.Control.closeDialog()
        yield from until(lambda: not Gui.Control.activeDialog(), "the panel to close")
    yield from settled()
    clear_report_view()


def growth(opened, last: int, what: str, found: list):
    """Measures how much more memory, MB, there is after the last opening than after `FIRST`."""
    yield from openings(opened, 0, FIRST)
    before, given, objects = megabytes(), resident(), kinds()
    yield from openings(opened, FIRST, last)
    found.append((megabytes() - before) / (last - FIRST))
    more = {name: n for name, n in (kinds() - objects).most_common(8) if n >= last - FIRST}
    told = f"{1000.0 * found[-1]:.0f} kB an opening, {resident() - given:+.1f} MB in all, {more}"
    note(f"memory of {what} from opening {FIRST} to {last}: {told}")


def kept_by(last: int):
    """Of so many openings of Move Handle each keeps less than `MOST`."""
    found: list = []
    yield from grid_part(SIDE)
    yield from growth(empty_panel, last, "an empty panel", found)
    yield from growth(move_handle, last, "Move Handle", found)
    assert found[-1] < MOST, found


def test_forty_openings_of_move_handle_keep_no_shape():
    yield from kept_by(40)


def test_300_openings_of_move_handle_keep_no_shape():
    yield from kept_by(300)
