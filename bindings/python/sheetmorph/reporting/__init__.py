# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report on a pose: figures, certificate, notes and warnings."""
