# SPDX-License-Identifier: LGPL-2.1-or-later
"""All mutations, in the order in which they are planted."""
from mutation import Mutation

from . import assembly, base, cad, mesh, numerics, pick, recognise, repair, surface, volume

MUTATIONS: list[Mutation] = [
    mutation
    for layer in (base, numerics, mesh, pick, repair, volume, recognise, cad, surface, assembly)
    for mutation in layer.MUTATIONS
]
