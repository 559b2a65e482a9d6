# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an open panel needs of the program: one session that ends in one way and leaves nothing.

Transactions, document observers, the 3D view and what is shown in it are handled here alone.
"""
