// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/anchor.h"
#include "sheetmorph/surface/bodies/vertex_roles.h"

namespace sheetmorph::surface
{

//! Places vertices after the solve. Vertices of degenerate triangles keep their position relative
//! to the nearest triangle without such a vertex:
//! p = sum_j beta_j (p_j + R_j (p_hat - p_hat_j)) .
//! Tied vertices keep their distance from their point q on another sheet:
//! p = q + R (p_hat - q_hat) ,
//! with the rotation of the logs there.
class Followers
{
public:
    Followers(const mesh::TriangleMesh& rest, const VertexRoles& roles);

    //! Fills the followers' rows of `positions` and `rotation_logs`, both (n, 3).
    void place(const mesh::TriangleMesh& rest, Points& positions, Points& rotation_logs) const;

    bool is_empty() const { return ties_.empty() && followers_.empty(); }

    //! The vertices that place() reads, ascending.
    VertexIds corners() const;

private:
    struct Follower
    {
        int vertex;
        mesh::Anchor anchor;
    };
    std::vector<Tie> ties_;
    std::vector<Follower> followers_;
};

}  // namespace sheetmorph::surface
