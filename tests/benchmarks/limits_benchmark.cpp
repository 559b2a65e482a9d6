// SPDX-License-Identifier: LGPL-2.1-or-later
// What the machine and a well-kept library allow: CHOLMOD's factor of the panel's reduced matrix,
// one plain back-substitution in it, and reading as many bytes as a live frame reads.
#include "panel_cases.h"

#include "sheetmorph/surface/operators/surface_operators.h"

#include <cholmod.h>
#include <numeric>

namespace sheetmorph::benchmarks
{

using namespace numerics;

namespace
{

// S: unknowns are the free vertices and one for every hole.
SparseMatrix unknowns_of(const Panel& panel)
{
    const int count = panel.mesh.vertex_count();
    std::vector<int> of_vertex(static_cast<std::size_t>(count), 0);
    for (const auto* known : {&panel.constraints.fixed, &panel.constraints.handles})
        for (const surface::KnownRegion& region : *known)
            for (const int vertex : region.vertices)
                of_vertex[static_cast<std::size_t>(vertex)] = -1;
    int hole = 0;
    for (const surface::FormFeature& feature : panel.constraints.features)
    {
        ++hole;
        for (const int vertex : feature.vertices)
            of_vertex[static_cast<std::size_t>(vertex)] = hole;
    }
    std::vector<Eigen::Triplet<double>> entries;
    int next = hole;
    for (int i = 0; i < count; ++i)
    {
        const int role = of_vertex[static_cast<std::size_t>(i)];
        if (role >= 0)
            entries.emplace_back(i, role > 0 ? role - 1 : next++, 1.0);
    }
    SparseMatrix basis(count, next);
    basis.setFromTriplets(entries.begin(), entries.end());
    return basis;
}

SparseMatrix reduced_bilaplacian(const Panel& panel)
{
    const surface::SurfaceOperators operators = surface::surface_operators(panel.mesh, {}, {});
    const SparseMatrix rows =
        operators.weights.cwiseSqrt().asDiagonal() * operators.rows * unknowns_of(panel);
    return SparseMatrix(rows.transpose()) * rows;
}

// A factor as CHOLMOD makes it when nothing is set.
class PlainCholmod
{
public:
    explicit PlainCholmod(SparseMatrix matrix)
    {
        cholmod_start(&common_);
        cholmod_sparse view{};
        view.nrow = view.ncol = static_cast<std::size_t>(matrix.rows());
        view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
        view.p = matrix.outerIndexPtr();
        view.i = matrix.innerIndexPtr();
        view.x = matrix.valuePtr();
        view.stype = -1;
        view.xtype = CHOLMOD_REAL;
        view.sorted = view.packed = 1;
        factor_ = cholmod_analyze(&view, &common_);
        cholmod_factorize(&view, factor_, &common_);
        right_side_ = cholmod_ones(view.nrow, 3, CHOLMOD_REAL, &common_);
    }
    ~PlainCholmod()
    {
        cholmod_free_dense(&right_side_, &common_);
        cholmod_free_factor(&factor_, &common_);
        cholmod_finish(&common_);
    }
    PlainCholmod(const PlainCholmod&) = delete;
    PlainCholmod& operator=(const PlainCholmod&) = delete;

    void substitute()
    {
        cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor_, right_side_, &common_);
        cholmod_free_dense(&solution, &common_);
    }

private:
    cholmod_common common_{};
    cholmod_factor* factor_ = nullptr;
    cholmod_dense* right_side_ = nullptr;
};

void cholmod_factorisation(benchmark::State& state)
{
    const Panel& panel = panel_of(static_cast<int>(state.range(0)));
    const SparseMatrix matrix = reduced_bilaplacian(panel);
    for (auto step : state)
    {
        (void)step;
        PlainCholmod factor(matrix);
        benchmark::DoNotOptimize(factor);
    }
    state.counters["vertices"] = panel.mesh.vertex_count();
}

void cholmod_substitution(benchmark::State& state)
{
    const Panel& panel = panel_of(static_cast<int>(state.range(0)));
    PlainCholmod factor(reduced_bilaplacian(panel));
    for (auto step : state)
    {
        (void)step;
        factor.substitute();
    }
    state.counters["vertices"] = panel.mesh.vertex_count();
}

// 25 columns of float32 and the rest shape in double, read once by one core.
void reading_once(benchmark::State& state)
{
    const Panel& panel = panel_of(static_cast<int>(state.range(0)));
    const std::vector<float> numbers(static_cast<std::size_t>(panel.mesh.vertex_count()) * 31,
                                     1.0F);
    using Lanes = float __attribute__((vector_size(64), aligned(4), may_alias));
    for (auto step : state)
    {
        (void)step;
        Lanes sums[4] = {};
        for (std::size_t k = 0; k + 64 <= numbers.size(); k += 64)
            for (std::size_t part = 0; part < 4; ++part)
                sums[part] += *reinterpret_cast<const Lanes*>(&numbers[k + 16 * part]);
        benchmark::DoNotOptimize(sums);
    }
    state.counters["vertices"] = panel.mesh.vertex_count();
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(numbers.size() * 4));
}

BENCHMARK(cholmod_factorisation)->Apply(small_panel_sizes);
BENCHMARK(cholmod_substitution)->Apply(small_panel_sizes);
BENCHMARK(reading_once)->Apply(panel_sizes);

}  // namespace

}  // namespace sheetmorph::benchmarks
