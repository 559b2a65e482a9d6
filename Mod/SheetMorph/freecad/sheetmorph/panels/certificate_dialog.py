# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog with the result of a certificate, and a button that opens its page."""

import json
from html import escape
from pathlib import Path

import FreeCADGui as Gui

from freecad.sheetmorph.qt import QtCore, QtGui, QtWidgets, connect, translate

PASSED, FAILED = "#0f8a5f", "#c4231f"
SHOWN = 12


def show(folder: str) -> None:
    """Show the certificate in a folder; Open Page shows all of it in the browser."""
    certificate = json.loads((Path(folder) / "certificate.json").read_text("utf-8"))
    dialog = QtWidgets.QDialog(Gui.getMainWindow())
    dialog.setObjectName("SheetMorphCertificate")
    dialog.setWindowTitle(translate("SheetMorph_panels", "Certificate"))
    dialog.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    text = QtWidgets.QLabel(summary(certificate, folder), dialog)
    text.setObjectName("certificate")
    text.setWordWrap(True)
    text.setMinimumWidth(460)
    text.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    buttons = QtWidgets.QDialogButtonBox(QtWidgets.QDialogButtonBox.Close, dialog)
    page = QtCore.QUrl.fromLocalFile(str(Path(folder) / "certificate.html"))
    label = translate("SheetMorph_panels", "Open Page")
    opened = buttons.addButton(label, QtWidgets.QDialogButtonBox.ActionRole)
    connect(opened, "clicked()", lambda: QtGui.QDesktopServices.openUrl(page))
    connect(buttons, "rejected()", dialog.reject)
    column = QtWidgets.QVBoxLayout(dialog)
    column.addWidget(text)
    column.addWidget(buttons)
    dialog.show()


def summary(certificate: dict, folder: str) -> str:
    """Return the result and the failed criteria as rich text."""
    passed, failures = certificate["passed"], certificate["failures"]
    word = (
        translate("SheetMorph_panels", "Certified")
        if passed
        else translate("SheetMorph_panels", "Not certified")
    )
    colour, name = PASSED if passed else FAILED, certificate["criteria"]["name"]
    counts = translate(
        "SheetMorph_panels", "Parts: {0}, form features: {1}, contacts: {2}, joints: {3}"
    )
    joints = sum(deck["joints"]["count"] for deck in certificate["decks"])
    found = (len(certificate[key]) for key in ("parts", "features", "contacts"))
    lines = [f"<b style='color:{colour}; font-size:large'>{word}</b> ({escape(name)})"]
    lines.append(counts.format(*found, joints))
    lines += [f"&bull; {escape(text)}" for text in failures[:SHOWN]]
    if len(failures) > SHOWN:
        lines.append(translate("SheetMorph_panels", "and {0} more").format(len(failures) - SHOWN))
    lines.append(f"<br>{escape(folder)}")
    return "<br>".join(lines)
