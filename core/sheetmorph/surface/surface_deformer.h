// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/constraints/constraints.h"
#include "sheetmorph/surface/constraints/targets.h"
#include "sheetmorph/surface/solve/deformation.h"

#include <memory>

namespace sheetmorph::surface
{

class Response;
struct ResponseReaders;

//! Deforms one part as a thin plate with rigid form features (2.9, 2.10). The constructor
//! factorises (pre-processing phase); deform() only back-substitutes (interactive phase).
class SurfaceDeformer
{
public:
    //! \param earlier  the same part under other constraints; reuses all unchanged data
    //! \throws InvalidInput naming ids: an unsupported component, contradicting constraints
    //! \throws Cancelled    on request of the progress callback
    SurfaceDeformer(const mesh::TriangleMesh& rest, const SurfaceConstraints& constraints,
                    const Progress& progress = {}, const SurfaceDeformer* earlier = nullptr);
    ~SurfaceDeformer();
    SurfaceDeformer(SurfaceDeformer&&) noexcept;
    SurfaceDeformer& operator=(SurfaceDeformer&&) noexcept;

    //! Always starts from rest, so a pose has one result regardless of earlier poses. Fixed and
    //! handle vertices meet their targets bitwise, features are rigid, and points meet their
    //! targets to exactness().
    //! \throws InvalidInput if point targets contradict each other or a rigid or fixed region
    //! \throws Cancelled    on request of the progress callback
    Deformation deform(const SurfaceTargets& targets, Exactness exactness = Exactness::exact,
                       const Progress& progress = {}) const;

    //! A reduced model of the part's response, trained on sample poses, for live frames without
    //! back-substitution (response.h). The deformer must outlive it.
    //! \throws Cancelled on request of the progress callback
    std::unique_ptr<Response> response(const std::vector<SurfaceTargets>& samples,
                                       const ResponseReaders& readers,
                                       const Progress& progress = {}) const;

    //! Whether response() supports the part.
    bool can_respond() const;

    const mesh::TriangleMesh& rest() const;
    const SurfaceConstraints& constraints() const;

    //! Entries of the sparse factor, for memory reports.
    double factor_entries() const;

private:
    struct Precomputed;
    std::unique_ptr<const Precomputed> data_;
};

}  // namespace sheetmorph::surface
