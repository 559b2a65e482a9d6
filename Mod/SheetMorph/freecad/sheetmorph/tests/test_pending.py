# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pose that is pending in a panel: whatever fails, the next panel begins without it."""

import random
import unittest
from contextlib import suppress
from functools import partial

import FreeCAD

from freecad.sheetmorph import api
from freecad.sheetmorph.api.poses import restore, snapshot
from freecad.sheetmorph.editing import transactions
from freecad.sheetmorph.editing.pending import Pending
from freecad.sheetmorph.tests import support

TRIES = 60


class Planned(Exception):
    """What is made to fail."""


class TestPending(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.assembly, self.part, self.handle = self.add_morph()
        self.document.recompute()
        self.document.UndoMode = 1
        self.document.clearUndos()
        self.left = 0  # calls until one fails

    def pending(self) -> Pending:
        read, write = partial(snapshot, self.assembly), partial(restore, self.assembly)
        return Pending(self.document, "Move", self.failing(read), self.failing(write))

    def failing(self, function):
        def call(*arguments):
            self.left -= 1
            if self.left == 0:
                raise Planned
            return function(*arguments)

        return call

    def acts(self, pending: Pending) -> list:
        """What a panel and others do, one after the other."""

        def move() -> None:
            pending.change()
            self.handle.TranslationZ = self.handle.TranslationZ.Value + 5.0
            pending.settle()

        def interrupt() -> None:
            with suppress(Planned):  # FreeCAD goes on
                pending.on_close(False)
            FreeCAD.closeActiveTransaction(False, 0)
            pending.resume()

        def undo() -> None:
            if self.document.HasPendingTransaction:
                with suppress(Planned):
                    pending.on_close(False)
                self.document.undo()
                if pending.on_undo():
                    pending.resume()

        def aside() -> None:
            with pending.aside():
                raise Planned

        return [move, move, interrupt, undo, aside]

    def test_after_an_exception_the_next_panel_inherits_no_pose(self):
        dice = random.Random(37)
        for number in range(TRIES):
            before = snapshot(self.assembly)
            self.left = 0
            pending = self.pending()
            self.left = dice.randrange(1, 9)
            for act in dice.choices(self.acts(pending), k=4):
                with suppress(Planned):
                    act()
            with suppress(Planned):
                pending.take_back()
            self.left = 0
            with self.subTest(number=number):
                self.assertEqual(snapshot(self.assembly), before)
                self.assertFalse(self.document.HasPendingTransaction)
                self.assertIsNone(FreeCAD.getActiveTransaction())
            self.look_at_the_next_panel()

    def look_at_the_next_panel(self) -> None:
        """Its step is its own: an undo takes back what it did, and nothing besides."""
        before = snapshot(self.assembly)
        pending = self.pending()
        pending.change()
        api.set_motion(self.handle, (1.0, 0.0, 0.0))
        pending.keep()
        self.document.undo()
        self.assertEqual(snapshot(self.assembly), before)
        transactions.forget_redos(self.document)


if __name__ == "__main__":
    unittest.main()
