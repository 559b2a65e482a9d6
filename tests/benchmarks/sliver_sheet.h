// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <benchmark/benchmark.h>

namespace sheetmorph::benchmarks
{

//! mm: the edges of sliver_sheet(), and those that remeshing asks for.
constexpr double sheet_edge = 10.0;
constexpr double wanted_edge = 0.77 * sheet_edge;

//! Every third triangle gets a fourth vertex near the middle of one of its edges: three in its
//! place, one of them a sliver.
mesh::TriangleMesh with_slivers(const mesh::TriangleMesh& mesh);

//! A curved open sheet with 20 round holes, a third of its triangles slivers.
const mesh::TriangleMesh& sliver_sheet();

//! Counts what remeshing sliver_sheet() made: triangles, their smallest angles, and how far
//! corners and middles of edges are from the sheet given.
void count_remeshed(const mesh::TriangleMesh& made, benchmark::State& state);

}  // namespace sheetmorph::benchmarks
