// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/operators/stitches.h"

#include "sheetmorph/base/index.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// By stitch: its vertices.
std::vector<VertexIds> members(const VertexRoles& roles)
{
    std::vector<VertexIds> found;
    for (std::size_t i = 0; i < roles.stitch.size(); ++i)
        if (const int stitch = roles.stitch[i]; stitch >= 0)
        {
            found.resize(std::max(found.size(), at(stitch) + 1));
            found[at(stitch)].push_back(static_cast<int>(i));
        }
    return found;
}

}  // namespace

SharedUnknowns::SharedUnknowns(const VertexRoles& roles)
    : roles_(roles),
      of_body_(roles.bodies.size(), Unknowns::known),
      of_stitch_(members(roles).size(), Unknowns::known)
{
}

void SharedUnknowns::add(bool is_open)
{
    const std::size_t i = unknowns_.of_vertex.size();
    int unknown = Unknowns::known;
    if (is_open)
    {
        int* shared = &unknown;
        if (roles_.role[i] == Role::body)
            shared = &of_body_[at(roles_.owner[i])];
        else if (roles_.stitch[i] >= 0)
            shared = &of_stitch_[at(roles_.stitch[i])];
        if (*shared == Unknowns::known)
            *shared = unknowns_.count++;
        unknown = *shared;
    }
    unknowns_.of_vertex.push_back(unknown);
}

void join_stitched(const VertexRoles& roles, SparseMatrix& sums, Points& rest,
                   Eigen::VectorXd& areas)
{
    const std::vector<VertexIds> stitches = members(roles);
    if (stitches.empty())
        return;
    std::vector<int> row_of(roles.stitch.size());
    for (std::size_t i = 0; i < row_of.size(); ++i)
        row_of[i] =
            roles.stitch[i] >= 0 ? stitches[at(roles.stitch[i])].front() : static_cast<int>(i);
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < sums.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(sums, column); entry; ++entry)
            entries.emplace_back(row_of[at(entry.row())], column, entry.value());
    sums.setFromTriplets(entries.begin(), entries.end());
    for (std::size_t i = 0; i < row_of.size(); ++i)
        if (const int row = row_of[i]; row != static_cast<int>(i))
        {
            const auto own = static_cast<Eigen::Index>(i);
            rest.row(row) += rest.row(own);
            rest.row(own).setZero();
            areas(row) += areas(own);
            areas(own) = 0.0;
        }
}

VertexIds seam_vertices(const VertexRoles& roles, const std::vector<char>& is_interior)
{
    VertexIds found;
    for (const VertexIds& stitch : members(roles))
        if (std::none_of(stitch.begin(), stitch.end(),
                         [&](int vertex) { return is_interior[at(vertex)] != 0; }))
            found.push_back(stitch.front());
    return found;
}

StitchArms::StitchArms(const TriangleMesh& rest, const VertexRoles& roles)
{
    for (const VertexIds& stitch : members(roles))
    {
        const Vector3 middle = centre_of(rest, stitch);
        for (const int vertex : stitch)
            arms_.emplace_back(vertex, rest.points().row(vertex).transpose() - middle);
    }
}

void StitchArms::turn(const std::vector<Matrix3>& change, Eigen::MatrixXd& offset) const
{
    for (const auto& [vertex, arm] : arms_)
        offset.row(vertex) += (change[at(vertex)] * arm).transpose();
}

}  // namespace sheetmorph
