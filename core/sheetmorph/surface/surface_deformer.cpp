// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/surface_deformer.h"

#include "sheetmorph/surface/live/sampled_response.h"
#include "sheetmorph/surface/solve/pose_solve.h"

namespace sheetmorph
{

struct SurfaceDeformer::Precomputed : PreparedSurface
{
    using PreparedSurface::PreparedSurface;
};

namespace
{

ResponseInput response_input(const PreparedSurface& part)
{
    return {part.placement(), part.operators, *part.field,
            part.minimiser,   part.followers, part.responses.get()};
}

}  // namespace

SurfaceDeformer::SurfaceDeformer(const TriangleMesh& rest, const SurfaceConstraints& constraints,
                                 const Progress& progress, const SurfaceDeformer* earlier)
    : data_(std::make_unique<const Precomputed>(
        rest, constraints, progress, earlier != nullptr ? earlier->data_.get() : nullptr))
{
}

SurfaceDeformer::~SurfaceDeformer() = default;
SurfaceDeformer::SurfaceDeformer(SurfaceDeformer&&) noexcept = default;
SurfaceDeformer& SurfaceDeformer::operator=(SurfaceDeformer&&) noexcept = default;

Deformation SurfaceDeformer::deform(const SurfaceTargets& targets, Exactness exactness) const
{
    return solve_pose(*data_, targets, exactness);
}

std::unique_ptr<SurfaceResponse> SurfaceDeformer::response(const ResponseOptions& options,
                                                           const Progress& progress) const
{
    return std::make_unique<SurfaceResponse>(response_input(*data_), options, progress);
}

bool SurfaceDeformer::can_respond() const
{
    return SurfaceResponse::is_possible(response_input(*data_));
}

std::unique_ptr<SampledResponse> SurfaceDeformer::sampled_response(
    const std::vector<SurfaceTargets>& samples, const VertexIds& reads,
    const Progress& progress) const
{
    return std::make_unique<SampledResponse>(response_input(*data_), samples, reads, progress);
}

bool SurfaceDeformer::can_be_sampled() const
{
    return SampledResponse::is_possible(response_input(*data_));
}

const TriangleMesh& SurfaceDeformer::rest() const
{
    return data_->rest;
}

const SurfaceConstraints& SurfaceDeformer::constraints() const
{
    return data_->constraints;
}

double SurfaceDeformer::factor_entries() const
{
    return data_->minimiser.factor_entries();
}

}  // namespace sheetmorph
