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

//! Deforms one part as a thin plate whose form features stay rigid (2.9, 2.10).
//! The constructor factorises (pre-processing phase), deform() only substitutes (interactive
//! phase).
class SurfaceDeformer
{
public:
    //! \param earlier  the same part under other constraints: what does not change is taken over
    //! \throws InvalidInput naming ids: a component that nothing holds, constraints that contradict
    //! \throws Cancelled    if the progress callback asks for it
    SurfaceDeformer(const mesh::TriangleMesh& rest, const SurfaceConstraints& constraints,
                    const Progress& progress = {}, const SurfaceDeformer* earlier = nullptr);
    ~SurfaceDeformer();
    SurfaceDeformer(SurfaceDeformer&&) noexcept;
    SurfaceDeformer& operator=(SurfaceDeformer&&) noexcept;

    //! Always from rest, so a pose has one answer whatever came before. Fixed and handle vertices
    //! are met bitwise, features are rigid and points met to exactness().
    //! \throws InvalidInput if point targets contradict each other or what is rigid or fixed
    //! \throws Cancelled if the progress callback asks for it
    Deformation deform(const SurfaceTargets& targets, Exactness exactness = Exactness::exact,
                       const Progress& progress = {}) const;

    //! How the part answers to whatever drives it, learnt from poses, for live frames without
    //! substitution (response.h). The deformer must outlive it.
    //! \throws Cancelled if the progress callback asks for it
    std::unique_ptr<Response> response(const std::vector<SurfaceTargets>& samples,
                                       const ResponseReaders& readers,
                                       const Progress& progress = {}) const;

    //! Whether response() knows the part.
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
