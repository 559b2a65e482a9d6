// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "panel.h"

#include "sheetmorph/surface/surface_deformer.h"

#include <benchmark/benchmark.h>

namespace sheetmorph::benchmarks
{

//! Made once for every size; benchmarks of one size share them.
const Panel& panel_of(int vertices);
const surface::SurfaceDeformer& deformer_of(int vertices);

//! Forgets deformers, so that the peak memory of what follows is its own.
void forget_deformers();

//! Another pose at every call, as a drag gives them: the handle turned by up to 60 degrees and
//! moved by up to a tenth of the panel.
RigidMotion drag_motion(const Panel& panel, int step);
surface::SurfaceTargets drag(const Panel& panel, int step);

//! Largest memory of the process so far.
double peak_memory_mib();

//! 1e3, 1e4, 1e5, and 1e6 where SHEETMORPH_BENCH_LARGE is set; wall time, and the processor time
//! of all threads, which other work on the machine changes less.
void panel_sizes(benchmark::internal::Benchmark* family);

//! The same up to 1e5.
void small_panel_sizes(benchmark::internal::Benchmark* family);

}  // namespace sheetmorph::benchmarks
