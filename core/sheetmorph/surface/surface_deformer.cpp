// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/surface_deformer.h"

#include "sheetmorph/surface/live/response.h"
#include "sheetmorph/surface/solve/pose_solve.h"

namespace sheetmorph::surface
{

struct SurfaceDeformer::Precomputed : PreparedSurface
{
    using PreparedSurface::PreparedSurface;
};

SurfaceDeformer::SurfaceDeformer(const mesh::TriangleMesh& rest,
                                 const SurfaceConstraints& constraints, const Progress& progress,
                                 const SurfaceDeformer* earlier)
    : data_(std::make_unique<const Precomputed>(
        rest, constraints, progress, earlier != nullptr ? earlier->data_.get() : nullptr))
{
}

SurfaceDeformer::~SurfaceDeformer() = default;
SurfaceDeformer::SurfaceDeformer(SurfaceDeformer&&) noexcept = default;
SurfaceDeformer& SurfaceDeformer::operator=(SurfaceDeformer&&) noexcept = default;

Deformation SurfaceDeformer::deform(const SurfaceTargets& targets, Exactness exactness,
                                    const Progress& progress) const
{
    return solve_pose(*data_, targets, exactness, progress);
}

std::unique_ptr<Response> SurfaceDeformer::response(const std::vector<SurfaceTargets>& samples,
                                                    const ResponseReaders& readers,
                                                    const Progress& progress) const
{
    return std::make_unique<Response>(*data_, samples, readers, progress);
}

bool SurfaceDeformer::can_respond() const
{
    return Response::is_possible(*data_);
}

const mesh::TriangleMesh& SurfaceDeformer::rest() const
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

}  // namespace sheetmorph::surface
