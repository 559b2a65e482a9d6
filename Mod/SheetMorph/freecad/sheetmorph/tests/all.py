# SPDX-License-Identifier: LGPL-2.1-or-later
"""All tests of the workbench that need no window, in one go."""

import unittest

from freecad.sheetmorph.tests import MODULES


def load_tests(loader: unittest.TestLoader, _tests, _pattern) -> unittest.TestSuite:
    """Return the tests of all modules; unittest calls this instead of looking here."""
    return loader.loadTestsFromNames(MODULES)
