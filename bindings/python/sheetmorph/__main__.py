# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entry point of python3 -m sheetmorph."""

import sys

from .cli import main

if __name__ == "__main__":
    sys.exit(main())
