# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels: widgets and what they mean; no geometry and no Coin."""
