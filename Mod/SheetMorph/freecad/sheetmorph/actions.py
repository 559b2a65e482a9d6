# SPDX-License-Identifier: LGPL-2.1-or-later
"""One user action = one transaction = one line in the recorded macro, a call of the public API."""

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
    """How a macro line addresses a document object: as an attribute of its document, unless that
    has one of its own of this name."""
    if getattr(obj.Document, obj.Name, None) == obj:
        return f"{DOCUMENT}.{obj.Name}"
    return f"{DOCUMENT}.getObject({obj.Name!r})"


def call(function: str, *arguments: str, **keywords: str) -> str:
    """The text of an API call; arguments are already source text."""
    texts = list(arguments) + [f"{key}={value}" for key, value in keywords.items()]
    return f"{API}.{function}({', '.join(texts)})"


def new_document(label: str = "") -> App.Document:
    """Makes a document, as lines that a macro runs anywhere. Whoever watches documents may have
    made another one the active one since, or none."""
    before = App.listDocuments().keys()
    record("import FreeCAD as App", f"App.newDocument({label!r})" if label else "App.newDocument()")
    return next(made for name, made in App.listDocuments().items() if name not in before)


def record(*lines: str, document=None) -> None:
    """Runs lines and writes them to the macro being recorded, without a transaction.

    The document they mean is made the active one for each: what happens under progress may make
    another one so. The imports are written every time: FreeCAD's addModule does so once a session,
    too early for a macro whose recording starts later.
    """
    told, every = reporting.progress(), (*IMPORTS, *lines)
    with together():
        for number, line in enumerate(every):
            if told is not None and not told(number / len(every), ""):
                return
            do(line, document)


def do(line: str, document=None) -> None:
    """Runs a line and writes it to the macro being recorded."""
    if document is not None and App.ActiveDocument != document:
        App.setActiveDocument(document.Name)
    with unseen() if len(line) > LONGEST_SHOWN else nullcontext():
        Gui.doCommand(line)


def note(*lines: str) -> None:
    """Writes lines to the macro being recorded whose work is done already, as it is shown.

    FreeCAD writes only what it runs: meanwhile the API's name stands for something that does
    nothing, and what the lines call a result is forgotten.
    """
    record()
    names = vars(sys.modules["__main__"])  # where FreeCAD runs lines
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
    """Has every attribute, takes every argument, and does nothing."""

    def __getattr__(self, _name: str) -> "Idle":
        return self

    def __call__(self, *_arguments, **_keywords) -> "Idle":
        return self


@contextmanager
def unseen():
    """Lines in this context go into the macro and not into the Python console: a thousand ids."""
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
    """Runs lines as one undo step called ``title``; on an error nothing has happened.

    A morph that was sound and is not afterwards, by what the step has made, is an error too.
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
        document.recompute()  # FreeCAD counts as due what was taken back
        raise


def refuse(fault) -> None:
    """Raises what a step has done wrong, None for nothing."""
    if fault is not None:
        raise MorphError(fault)


def attempt(title: str, *lines: str, document=None) -> bool:
    """As :func:`run`; reports an error, and returns False then."""
    return has_done(title, lambda: run(title, *lines, document=document))


def has_done(title: str, act) -> bool:
    """Whether ``act()`` came to its end. Else the user has cancelled it, or the error is
    reported: an unforeseen one, too."""
    try:
        act()
    except Cancelled:
        return False
    except Exception as error:
        tell(title, error)
        return False
    return True


def wait(title: str, *lines: str) -> bool:
    """Runs lines that write files, with progress; False if the user has pressed Cancel."""
    try:
        with followed(title):
            record(*lines)
    except Cancelled:
        return False
    return True


def tell(title: str, error: Exception | str) -> None:
    """Tells the user what went wrong: in the report view, and as FreeCAD tells its own errors."""
    sentence = reported(error)
    if not generations.shows_errors():
        QtWidgets.QMessageBox.warning(Gui.getMainWindow(), title, sentence)


def reported(error: Exception | str) -> str:
    """Writes an error to the report view and returns its sentence. An unforeseen one is a mistake
    of the program: its traceback comes first."""
    sentence = str(faults.fault_of(error))
    if not is_foreseen(error):
        text = translate(
            "SheetMorph_actions", "This is a mistake of the program ({0}). Please report it."
        )
        sentence = text.format(f"{type(error).__name__}: {sentence}")
        App.Console.PrintError("".join(traceback.format_exception(error)))
    App.Console.PrintError(f"SheetMorph: {sentence}\n")
    return sentence


def is_foreseen(error: Exception | str) -> bool:
    """Whether the program raises such an error on purpose, with a sentence for the user."""
    is_known = isinstance(error, (str, *FORESEEN)) and not isinstance(error, RecursionError)
    return is_known and bool(str(error).strip())


class Cancelled(RuntimeError):
    """The user did not want to wait any longer."""


@contextmanager
def followed(title: str):
    """Context with the waiting cursor; what takes long shows how far it is, with Cancel.

    Raises Cancelled if the user has pressed that.
    """
    progress = Progress(title)
    cancelled = Cancelled(translate("SheetMorph_actions", "Cancelled; nothing was changed."))
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
    """Context with the waiting cursor."""

    def __enter__(self):
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)

    def __exit__(self, *_):
        QtWidgets.QApplication.restoreOverrideCursor()
