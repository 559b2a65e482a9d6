// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/solve/sheet_growth.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/topology/edges.h"

#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

constexpr double nearest = 1e-9;  // mm; chosen only to avoid a division by zero

// Vertices that no size moves: all that are not free, borders, and the triangles of points.
std::vector<char> held_vertices(const RotationFieldInput& input)
{
    std::vector<char> is_held(at(input.mesh.vertex_count()), 0);
    for (std::size_t i = 0; i < is_held.size(); ++i)
        is_held[i] = input.roles.role[i] != Role::free;
    const mesh::EdgeTable table(input.mesh);
    for (int edge = 0; edge < table.count(); ++edge)
        if (table.uses(edge).count() == 1)
        {
            is_held[at(table.uses(edge).begin()->from)] = 1;
            is_held[at(table.uses(edge).begin()->to)] = 1;
        }
    for (const PointConstraint& point : input.constraints.points)
        for (int k = 0; k < 3; ++k)
            is_held[at(input.mesh.triangles()(point.triangle, k))] = 1;
    return is_held;
}

// Edge weights, larger near resizable features as 1/distance. A rim in a round sheet then displaces
// the sheet evenly up to the border; plain harmonic functions would concentrate the change at the
// rim.
numerics::SparseMatrix even_stiffness(const RotationFieldInput& input, const FeatureShapes& shapes)
{
    numerics::SparseMatrix stiffness = *input.operators.harmonic;
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(stiffness.cols());
    for (Eigen::Index column = 0; column < stiffness.cols(); ++column)
        for (numerics::SparseMatrix::InnerIterator entry(stiffness, column); entry; ++entry)
        {
            if (entry.row() == column)
                continue;
            const Eigen::RowVector3d middle =
                0.5 * (input.mesh.points().row(entry.row()) + input.mesh.points().row(column));
            double nearness = 0.0;
            for (const std::optional<forms::FeatureShape>& shape : shapes)
                if (shape)
                    nearness += 1.0 / ((middle.transpose() - shape->centre).norm() + nearest);
            entry.valueRef() *= nearness;
            sums(column) -= entry.value();
        }
    // Columns of unused vertices are empty and have no diagonal entry.
    for (Eigen::Index column = 0; column < stiffness.cols(); ++column)
        for (numerics::SparseMatrix::InnerIterator entry(stiffness, column); entry; ++entry)
            if (entry.row() == column)
                entry.valueRef() = sums(column);
    return stiffness;
}

}  // namespace

SheetGrowth::SheetGrowth(const RotationFieldInput& input, const FeatureShapes& shapes)
    : mesh_(input.mesh), constraints_(input.constraints), roles_(input.roles), shapes_(shapes)
{
    const auto is_resizable = [](const std::optional<forms::FeatureShape>& shape)
    { return shape.has_value(); };
    if (std::none_of(shapes.begin(), shapes.end(), is_resizable))
        return;
    stiffness_ = std::make_shared<const numerics::SparseMatrix>(even_stiffness(input, shapes));
    find_unknowns(held_vertices(input));
    if (unknowns_.count > 0)
        factor_.emplace(unknowns_.merged(stiffness_), input.operators.harmonic_tree);
}

// The vertices connected to a resizable feature by paths without a constrained vertex.
void SheetGrowth::find_unknowns(const std::vector<char>& is_held)
{
    std::vector<char> is_reached(is_held.size(), 0);
    VertexIds open;
    for (std::size_t k = 0; k < shapes_.size(); ++k)
        if (shapes_[k])
            open.insert(open.end(), constraints_.features[k].vertices.begin(),
                        constraints_.features[k].vertices.end());
    while (!open.empty())
    {
        const int vertex = open.back();
        open.pop_back();
        for (numerics::SparseMatrix::InnerIterator entry(*stiffness_, vertex); entry; ++entry)
        {
            const auto next = at(entry.row());
            if (entry.value() == 0.0 || is_held[next] || is_reached[next])
                continue;
            is_reached[next] = 1;
            open.push_back(static_cast<int>(next));
        }
    }
    for (const char reached : is_reached)
        unknowns_.of_vertex.push_back(reached != 0 ? unknowns_.count++ : Unknowns::known);
}

Points SheetGrowth::field(const SizeChanges& sizes) const
{
    Points moves = Points::Zero(mesh_.vertex_count(), 3);
    for (std::size_t k = 0; k < sizes.size(); ++k)
    {
        const VertexIds& vertices = constraints_.features[k].vertices;
        for (std::size_t i = 0; i < vertices.size() && sizes[k]; ++i)
        {
            const auto row = static_cast<Eigen::Index>(i);
            if (roles_.role[at(vertices[i])] == Role::body)
                moves.row(vertices[i]) =
                    *sizes[k] * shapes_[k]->growth.row(row) + shapes_[k]->rounding.row(row);
        }
    }
    return spread(std::move(moves));
}

// Extends the displacements of the rims to the sheet between them.
Points SheetGrowth::spread(Points moves) const
{
    if (factor_)
        moves -= unknowns_.basis() * factor_->solve(unknowns_.sums(*stiffness_ * moves));
    return moves;
}

bool SheetGrowth::moves(int vertex) const
{
    return at(vertex) < unknowns_.of_vertex.size()
           && unknowns_.of_vertex[at(vertex)] != Unknowns::known;
}

void SheetGrowth::lay(const SizeChanges& sizes, Deformation& deformation) const
{
    const Points growth = field(sizes);
    for (int vertex = 0; vertex < static_cast<int>(unknowns_.of_vertex.size()); ++vertex)
    {
        if (!moves(vertex))
            continue;
        const Matrix3 turn = rotation_from_log(deformation.rotation_logs.row(vertex));
        deformation.positions.row(vertex) += (turn * growth.row(vertex).transpose()).transpose();
    }
    for (std::size_t k = 0; k < sizes.size(); ++k)
    {
        if (!sizes[k])
            continue;
        const Matrix3 turn = deformation.features[k].rotation();
        VertexIds vertices = constraints_.features[k].vertices;
        make_set(vertices);
        for (const int vertex : vertices)
            deformation.positions.row(vertex) +=
                (turn * growth.row(vertex).transpose()).transpose();
    }
}

}  // namespace sheetmorph::surface
