// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/operators/surface_operators.h"
#include "sheetmorph/surface/operators/unknowns.h"

namespace sheetmorph
{

//! Numbers unknowns one after the other: vertices of one body share theirs, as those of one stitch
//! do.
class SharedUnknowns
{
public:
    explicit SharedUnknowns(const VertexRoles& roles);

    //! The next vertex: one with an unknown of its own or one that it shares, or a known one.
    void add(bool is_open);

    Unknowns& found() { return unknowns_; }

private:
    const VertexRoles& roles_;
    std::vector<int> of_body_, of_stitch_;
    Unknowns unknowns_;
};

//! The rows of L as if stitched vertices were one: a row for the first of them, none for the
//! others, so that bending goes through a seam as through an inner edge.
//! \param sums   K (n, n), changed
//! \param rest   K p_hat (n, 3), changed
//! \param areas  (n) mm^2, changed: 0 where there is no row
void join_stitched(const VertexRoles& roles, SparseMatrix& sums, Points& rest,
                   Eigen::VectorXd& areas);

//! The first vertices of stitches that lie on the border of every sheet.
VertexIds seam_vertices(const VertexRoles& roles, const std::vector<char>& is_interior);

//! By stitched vertex: from the middle of its stitch to it, mm.
class StitchArms
{
public:
    StitchArms(const TriangleMesh& rest, const VertexRoles& roles);

    //! What stitched vertices move besides, where the sheet turns: p_i = s + R_i a_i.
    //! \param change  (n) R - I at every vertex
    //! \param offset  (n, 3), added to
    void turn(const std::vector<Matrix3>& change, Eigen::MatrixXd& offset) const;

    //! use(vertex, arm) for all of them.
    template <typename Use>
    void for_each(const Use& use) const
    {
        for (const auto& [vertex, arm] : arms_)
            use(vertex, arm);
    }

private:
    std::vector<std::pair<int, Vector3>> arms_;
};

}  // namespace sheetmorph
