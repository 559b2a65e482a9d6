# SPDX-License-Identifier: LGPL-2.1-or-later
"""User actions: each is one transaction and one macro line, a call of the public API."""

import sys
import traceback
from contextlib import contextmanager, nullcontext

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import generations, reporting
from freecad.sheetmorph.bridge import faults
from freecad.sheetmorph.editing import transactions
from freecad.sheetmorph.objects.assembly import together
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.progress_dialog import Progress
from freecad.sheetmorph.qt import QtCore, QtWidgets, translate

API = "api"
IMPORTS = (f"import freecad.sheetmorph.api as {API}",)
DOCUMENT = f"{API}.doc"
LONGEST_SHOWN = 300  # characters
FORESEEN = (ValueError, RuntimeError, OSError)
FAULTS = (ValueError, RuntimeError, OSError, TypeError, KeyError)


def name(obj) -> str:
    """Return the expression for a document object in a macro line.

    It is an attribute of the document, unless the document has another attribute of this name.
    """
    if getattr(obj.Document, obj.Name, None) == obj:
        return f"{DOCUMENT}.{obj.Name}"
    return f"{DOCUMENT}.getObject({obj.Name!r})"


def call(function: str, *arguments: str, **keywords: str) -> str:
    """Return the text of an API call; arguments are already source text."""
    texts = list(arguments) + [f"{key}={value}" for key, value in keywords.items()]
    return f"{API}.{function}({', '.join(texts)})"


def new_document(label: str = "") -> App.Document:
    """Create a document by lines that a macro can run anywhere.

    Observers of documents may have activated another document since, or none.
    """
    before = App.listDocuments().keys()
    record("import FreeCAD as App", f"App.newDocument({label!r})" if label else "App.newDocument()")
    return next(made for name, made in App.listDocuments().items() if name not in before)


def record(*lines: str, document=None) -> None:
    """Run lines and write them to the recorded macro, without a transaction.

    Their document is activated for each line, because progress handles events that may activate
    another. The imports are written every time. FreeCAD's addModule writes them once per session,
    too early for a macro whose recording starts later.
    """
    told, every = reporting.progress(), (*IMPORTS, *lines)
    with together():
        for number, line in enumerate(every):
            if told is not None and not told(number / len(every), ""):
                return
            do(line, document)


def do(line: str, document=None) -> None:
    """Run a line and write it to the recorded macro."""
    if document is not None and App.ActiveDocument != document:
        App.setActiveDocument(document.Name)
    with unseen() if len(line) > LONGEST_SHOWN else nullcontext():
        Gui.doCommand(line)


def note(*lines: str) -> None:
    """Write lines to the recorded macro whose effect is present already.

    FreeCAD writes only lines that it runs. So the name of the API stands for an object without
    effect meanwhile, and variables that the lines assign are removed.
    """
    record()
    names = vars(sys.modules["__main__"])  # the namespace in which FreeCAD runs lines
    before = dict(names)
    names[API] = Idle()
    try:
        for line in lines:
            Gui.doCommand(line)
    finally:
        for new in names.keys() - before.keys():
            del names[new]
        names.update(before)


class Idle:
    """An object that has every attribute, accepts every argument and does nothing."""

    def __getattr__(self, _name: str) -> "Idle":
        return self

    def __call__(self, *_arguments, **_keywords) -> "Idle":
        return self


@contextmanager
def unseen():
    """Keep long lines of this context out of the Python console, but in the macro."""
    group, entry = App.ParamGet("User parameter:BaseApp/Preferences/Macro"), "ScriptToPyConsole"
    was_shown, is_default = group.GetBool(entry, True), entry not in group.GetBools()
    group.SetBool(entry, False)
    try:
        yield
    finally:
        group.SetBool(entry, was_shown)
        if is_default:
            group.RemBool(entry)


def run(title: str, *lines: str, document=None) -> None:
    """Run lines as one undo step called `title`; an error undoes all of it.

    A morph that was valid and is not after the step counts as an error too.
    """
    document = document or App.ActiveDocument
    before = faults.faults_in(document)
    try:
        with transactions.step(document, title), followed(title):
            record(*lines, document=document)
            if reporting.progress()(1.0, ""):
                do(f"{DOCUMENT}.recompute()", document)
            refuse(faults.new_fault(document, before))
    except MorphError:
        document.recompute()  # FreeCAD counts the undone changes as due
        raise


def refuse(fault) -> None:
    """Raise the fault of a step, if any."""
    if fault is not None:
        raise MorphError(fault)


def attempt(title: str, *lines: str, document=None) -> bool:
    """Run lines as `run` does; report an error and return False."""
    return has_done(title, lambda: run(title, *lines, document=document))


def has_done(title: str, act) -> bool:
    """Return whether `act()` succeeded.

    It returns False if the user has cancelled it, or after reporting any error, even an unexpected
    one.
    """
    try:
        act()
    except Cancelled:
        return False
    except Exception as error:
        tell(title, error)
        return False
    return True


def wait(title: str, *lines: str) -> bool:
    """Run lines that write files, with progress; return False if the user cancels."""
    try:
        with followed(title):
            record(*lines)
    except Cancelled:
        return False
    return True


def tell(title: str, error: Exception | str) -> None:
    """Report an error in the report view and in FreeCAD's usual way."""
    sentence = reported(error)
    if not generations.shows_errors():
        QtWidgets.QMessageBox.warning(Gui.getMainWindow(), title, sentence)


def reported(error: Exception | str) -> str:
    """Write an error to the report view and return its sentence.

    An unexpected error is a bug: its traceback comes first.
    """
    sentence = str(faults.fault_of(error))
    if not is_foreseen(error):
        text = translate("SheetMorph_actions", "SheetMorph has a bug ({0}). Please report it.")
        sentence = text.format(f"{type(error).__name__}: {sentence}")
        App.Console.PrintError("".join(traceback.format_exception(error)))
    App.Console.PrintError(f"SheetMorph: {sentence}\n")
    return sentence


def is_foreseen(error: Exception | str) -> bool:
    """Return whether the program raises such an error deliberately, with a sentence for users."""
    is_known = isinstance(error, (str, *FORESEEN)) and not isinstance(error, RecursionError)
    return is_known and bool(str(error).strip())


class Cancelled(RuntimeError):
    """The error for a job that the user cancelled."""


@contextmanager
def followed(title: str):
    """Show the wait cursor in this context, and progress with Cancel if it takes long.

    Raises Cancelled if the user cancels.
    """
    progress = Progress(title)
    cancelled = Cancelled(translate("SheetMorph_actions", "Cancelled. Nothing was changed."))
    try:
        with waiting(), reporting.told_to(progress):
            yield
    except FAULTS as error:
        if progress.is_cancelled:
            raise cancelled from error
        raise
    finally:
        progress.close()
    if progress.is_cancelled:
        raise cancelled


class waiting:
    """A context with the wait cursor."""

    def __enter__(self):
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)

    def __exit__(self, *_):
        QtWidgets.QApplication.restoreOverrideCursor()
