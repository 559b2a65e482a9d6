# SPDX-License-Identifier: LGPL-2.1-or-later
"""One step of the guide: a mark, a title, an explanation and buttons for commands."""

from freecad.sheetmorph.panels.base import say
from freecad.sheetmorph.qt import QtCore, connect, icon_of, translate
from freecad.sheetmorph.tools import guide

MARKS = {
    guide.DONE: ("✓", "#2e9e5b"),
    guide.NEXT: ("➜", "#e07b10"),
    guide.AFTER: ("○", "#e07b10"),
    guide.OPEN: ("○", "#8a8f96"),
    guide.OPTIONAL: ("○", "#8a8f96"),
    guide.FAULTY: ("!", "#d64545"),
}


class StepView:
    """The widgets of one step; its buttons call `run` with the name of a command."""

    def __init__(self, form, key: str, names):
        """Use the buttons of `form`, a large and a small one for each command in `names`."""
        self._form, self._key, self._names = form, key, names
        self._title = self._widget("title").text()
        self._presses = []

    def connect(self, run) -> None:
        """Let the buttons call `run` after the click, because it may close their panel."""
        for name in self._names:
            press = _Press(f"SheetMorph_{name}", run)
            self._presses.append(press)
            for button in self._buttons(name):
                connect(button, "clicked()", press.pressed)

    def show(self, step: guide.Step, commands) -> None:
        """Show the state of the step; buttons for the next action have text.

        `commands` maps names to all commands.
        """
        mark, colour = MARKS[step.state]
        is_here = step.state in (guide.NEXT, guide.AFTER, guide.FAULTY)
        self._widget("mark").setText(f'<b style="color:{colour}">{mark}</b>')
        self._widget("title").setText(f"<b>{self._title}</b>" if is_here else self._title)
        words = translate("SheetMorph_Guide", step.text).format(**step.values)
        say(self._widget("text"), words, step.state == guide.FAULTY)
        for name in self._names:
            command = commands[f"SheetMorph_{name}"]
            lacking = command.lacks()
            worded, small = self._buttons(name)
            dress((worded, small), command, lacking)
            worded.setVisible(is_here and not lacking)
            small.setVisible(not is_here)
            small.setEnabled(not lacking)

    def _widget(self, name: str):
        return getattr(self._form, f"{self._key}_{name}")

    def _buttons(self, name: str) -> tuple:
        return getattr(self._form, name), getattr(self._form, f"{name}_small")


class _Press:
    """The action of a button."""

    def __init__(self, name: str, run):
        self.name, self._run = name, run

    def pressed(self, *_) -> None:
        """Run the command after the click, because it may close the panel of the button."""
        QtCore.QTimer.singleShot(0, self._later)

    def _later(self) -> None:
        self._run(self.name)


def dress(buttons, command, lacking: str) -> None:
    """Give buttons the icon and texts of a command and what it lacks, unless they have them."""
    tooltip = translate(command.name, command.tooltip)
    if lacking:
        tooltip += "\n" + translate("SheetMorph_needs", lacking)
    words = [command.label, tooltip]
    for button in buttons:
        if [button.text(), button.toolTip()] != words:
            button.setIcon(icon_of(command.icon))
            button.setText(words[0])
            button.setToolTip(words[1])
