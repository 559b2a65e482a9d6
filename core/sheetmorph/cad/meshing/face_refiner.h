// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/meshing/face_refinement.h"

#include <algorithm>

namespace sheetmorph::cad
{

//! Squared sine of a triangle's smallest corner in space; -1 if it has no area or the wrong turn
//! in the parameter plane, or looks away from the surface.
double worth(const FaceVertex& a, const FaceVertex& b, const FaceVertex& c);

//! How far a point of a mesh is from the surface near some parameters, across the surface, mm.
double gap_at(const FaceSurface& surface, const Vector2& uv, const Vector3& on_mesh);

//! One face on its way to the wanted sizes, see refine_face().
class FaceRefiner
{
public:
    FaceRefiner(FaceMesh& mesh, const FaceSurface& surface, const FaceSizes& sizes);

    Convergence run();

private:
    struct Side
    {
        double excess;
        int t, k, a, b;
    };

    const FaceVertex& corner(int t, int k) const { return mesh_.vertex(mesh_.corner(t, k)); }

    template <typename Work>
    void for_each_side(Work&& work) const
    {
        mesh_.for_each_side(
            [&](int t, int k)
            {
                if (mesh_.is_free_side(t, k))
                    work(t, k);
            });
    }

    FaceVertex vertex_at(const Vector2& uv) const
    {
        FaceVertex made;
        made.uv = uv;
        made.point = surface_.point(uv);
        made.normal = surface_normal(surface_, uv);
        made.size = sizes_.edge;
        return made;
    }

    double length_excess(const FaceVertex& a, const FaceVertex& b) const;
    double bend_excess(const FaceVertex& a, const FaceVertex& b) const;
    double excess(const FaceVertex& a, const FaceVertex& b) const
    {
        return std::max(length_excess(a, b), bend_excess(a, b));
    }
    void spread_sizes();
    Convergence split_all();
    int split_round();
    bool try_split(const Side& side);
    Convergence flip_all();
    bool flip_if_better(int t, int k);
    void legalise(int v);
    void collapse_all();
    bool try_collapse(int v);
    void smooth_all();
    void smooth(int v);
    double worth_around(int v, const FaceVertex& moved, int without) const;

    FaceMesh& mesh_;
    const FaceSurface& surface_;
    const FaceSizes& sizes_;
    double shortest_ = 0.0;
};

}  // namespace sheetmorph::cad
