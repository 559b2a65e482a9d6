# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editing session of an open panel, which ends in one way and leaves no traces.

Only this package handles transactions, document observers and the choice of the 3D view.
"""
