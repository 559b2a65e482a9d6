# SPDX-License-Identifier: LGPL-2.1-or-later
"""Callbacks for Coin, FreeCAD and Qt that can be cut off, since these never release them."""


class Relay:
    """A callable that calls a function until `let_go`, and nothing afterwards."""

    __slots__ = ("_function",)  # what is kept for ever is small

    def __init__(self, function=None):
        self._function = function

    def __call__(self, *arguments):
        if self._function is not None:
            self._function(*arguments)

    def take(self, function) -> None:
        """Call another function from now on."""
        self._function = function

    def let_go(self) -> None:
        """Release the function."""
        self._function = None


class Watch:
    """A Coin sensor that calls `function()` when a node or field changes, until `end`."""

    # Pivy never frees the callback of a sensor, so sensors are used again: (sensor, relay) by kind.
    _free: dict = {}

    def __init__(self, kind, watched, function):
        """Watch a node with `kind` SoNodeSensor, a field with SoFieldSensor."""
        self._kind = kind
        unused = self._free.setdefault(kind, [])
        self._sensor, self._relay = unused.pop() if unused else new_sensor(kind)
        self._relay.take(lambda *_: function())
        self._sensor.attach(watched)

    def end(self) -> None:
        """Watch no longer; a second call does nothing."""
        if self._sensor is None:
            return
        self._sensor.detach()
        self._relay.let_go()
        self._free[self._kind].append((self._sensor, self._relay))
        self._sensor = None


def new_sensor(kind) -> tuple:
    """Return a sensor and the relay that it calls."""
    relay = Relay()
    sensor = kind(relay, None)
    sensor.thisown = False  # FreeCAD ends Coin before Python would delete it
    return sensor, relay
