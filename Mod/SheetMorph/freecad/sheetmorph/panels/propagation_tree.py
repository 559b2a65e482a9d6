# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tree of the Propagation panel: parts below those they follow, with their contacts."""

from freecad.sheetmorph import paths
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.properties import number_of
from freecad.sheetmorph.qt import QtCore, QtWidgets, icon_of, translate
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

OBJECT = QtCore.Qt.UserRole
HINT = QT_TRANSLATE_NOOP(
    "SheetMorph_panels",
    "No contact reaches these parts, so they stay at rest: mark a contact with a part above.",
)
ROW, LOW, HIGH = 18, 160, 420  # px: height of a row, least and largest height of the tree
IDLE = QT_TRANSLATE_NOOP(
    "SheetMorph_panels",
    "Contacts that transfer no motion: switched off, not reached, or not needed.",
)


def fill(tree, assembly, steps) -> None:
    """Show the steps of `api.propagation`, and last what is unreached or unused."""
    tree.clear()
    rows, used = {}, set()
    for step in steps:
        if step.level >= 0:
            rows[step.part.Name] = (step.level, _add_part(tree, assembly, step, rows))
            used.update(contact.Name for contact in step.contacts)
    reached = set(rows)
    rest = [part for part in model.parts(assembly) if part.Name not in reached]
    _add_group(tree, QT_TRANSLATE_NOOP("SheetMorph_panels", "Not reached"), rest, HINT)
    idle = [contact for contact in model.contacts(assembly) if contact.Name not in used]
    _add_group(tree, QT_TRANSLATE_NOOP("SheetMorph_panels", "Contacts not in use"), idle, IDLE)
    tree.expandAll()
    tree.setMinimumHeight(min(max(ROW * (_count(tree.invisibleRootItem()) + 2), LOW), HIGH))
    header = tree.header()
    header.setStretchLastSection(False)
    for column in range(tree.columnCount()):
        fit = QtWidgets.QHeaderView.ResizeToContents
        header.setSectionResizeMode(column, fit if column else QtWidgets.QHeaderView.Stretch)


def row_of(tree, obj_name: str):
    """Return the first row of an object, None without one."""
    flags = QtWidgets.QTreeWidgetItemIterator.All
    found = QtWidgets.QTreeWidgetItemIterator(tree, flags)
    while found.value() is not None:
        if found.value().data(0, OBJECT) == obj_name:
            return found.value()
        found += 1
    return None


def _count(row) -> int:
    """Return the number of rows below a row."""
    return sum(1 + _count(row.child(k)) for k in range(row.childCount()))


def sources(step) -> list:
    """Return the parts that a step's part follows, in the order of its contacts."""
    return [c.PartB if c.PartA == step.part else c.PartA for c in step.contacts]


def _add_part(tree, assembly, step, rows):
    above = [rows[source.Name] for source in sources(step) if source.Name in rows]
    nearest = min(above, key=lambda found: found[0], default=(0, tree))
    row = _row(nearest[1], step.part)
    row.setText(
        1,
        translate("SheetMorph_panels", "step {0}").format(step.level)
        if step.level
        else translate("SheetMorph_panels", "primary"),
    )
    if step.part == assembly.Primary:
        font = row.font(0)
        font.setBold(True)
        row.setFont(0, font)
    for contact, source in zip(step.contacts, sources(step)):
        origin = translate("SheetMorph_panels", "from {0}").format(source.Label)
        _add_contact(row, contact, origin)
    return row


def _add_contact(above, contact, origin: str) -> None:
    row = _row(above, contact)
    kind = contact.Type.replace("control ", "")
    row.setText(1, kind if contact.Active else translate("SheetMorph_panels", "off"))
    row.setToolTip(
        1, contact.Type if contact.Active else translate("SheetMorph_panels", "not in use")
    )
    row.setText(2, _millimetres(number_of(contact, "GapChange")) if contact.Active else "")
    row.setToolTip(0, f"{contact.Label}, {origin}: {_parts_of(contact)}")
    changed = translate("SheetMorph_panels", "Largest change of the gap between both sides")
    row.setToolTip(2, changed)
    if contact.Active and contact.Warning:
        row.setIcon(2, warning_icon())
        for column in range(3):
            row.setToolTip(column, contact.Warning)


def opened(assembly) -> list:
    """Return the contacts that open or close too far."""
    return [contact for contact in model.contacts(assembly) if contact.Active and contact.Warning]


def warning_icon():
    """Return the icon for a likely fault."""
    return QtWidgets.QApplication.style().standardIcon(QtWidgets.QStyle.SP_MessageBoxWarning)


def _add_group(tree, title: str, objects, hint: str) -> None:
    """Add a row with others below it, if there are any."""
    if not objects:
        return
    title, hint = (translate("SheetMorph_panels", text) for text in (title, hint))
    group = QtWidgets.QTreeWidgetItem(tree, [title])
    group.setToolTip(0, hint)
    group.setForeground(0, tree.palette().placeholderText())
    for obj in objects:
        if model.kind(obj) == model.CONTACT:
            _add_contact(group, obj, translate("SheetMorph_panels", "not in use"))
        else:
            _row(group, obj).setToolTip(0, hint)


def _row(above, obj):
    row = QtWidgets.QTreeWidgetItem(above, [obj.Label])
    row.setData(0, OBJECT, obj.Name)
    icon = "MarkContact" if model.kind(obj) == model.CONTACT else "Part"
    row.setIcon(0, icon_of(paths.icon(icon)))
    return row


def _parts_of(contact) -> str:
    return " – ".join(part.Label if part else "?" for part in (contact.PartA, contact.PartB))


def _millimetres(value: float) -> str:
    """Return a small length as text."""
    return f"{value:.3f}" if value >= 0.0005 or value == 0.0 else "< 0.001"
