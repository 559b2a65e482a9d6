# SPDX-License-Identifier: LGPL-2.1-or-later
"""The slider from before to after in the Move Handle panel, a view of the open motion."""

from freecad.sheetmorph.qt import QtCore, connect


class ShareFields(QtCore.QObject):
    """The slider of the displayed share of the motion; another motion returns it to the full one.

    The document keeps the full motion all the time.
    """

    def __init__(self, form):
        super().__init__()
        self._slider, self._live = form.share, None
        self._pose = None  # of which a share is shown
        connect(form.share, "valueChanged(int)", self._show)

    def connect(self, live) -> None:
        """Show the full motion in a new LiveUpdate."""
        self._live = live
        self._set_full()
        live.drawn.connect(self._follow)

    def leave(self) -> bool:
        """Show the full motion; return whether only a share of it was shown."""
        is_partial = self._slider.value() < self._slider.maximum()
        self._slider.setValue(self._slider.maximum())
        return is_partial

    def _show(self, *_) -> None:
        if self._live is None:
            return
        if self._share < 1.0:
            self._live.ask_share(self._share)
        else:
            self._pose = None
            self._live.ask()

    def _follow(self) -> None:
        """Return to the share after a refined frame of the same motion, else to the full one."""
        shown = self._live.shown
        if shown.share < 1.0:
            self._pose = shown.pose
        elif self._share < 1.0 and shown.pose == self._pose:
            self._show()
        elif self._share < 1.0 and self._pose is not None:
            self._set_full()

    @property
    def _share(self) -> float:
        return self._slider.value() / self._slider.maximum()

    def _set_full(self) -> None:
        self._pose = None
        self._slider.blockSignals(True)
        self._slider.setValue(self._slider.maximum())
        self._slider.blockSignals(False)
