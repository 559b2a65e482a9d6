// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/flat/flattening.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/mesh/geometry/components.h"
#include "sheetmorph/mesh/geometry/thinness.h"
#include "sheetmorph/mesh/topology/boundary.h"
#include "sheetmorph/mesh/topology/orientation.h"
#include "sheetmorph/surface/flat/flat_system.h"

#include <Eigen/Geometry>

namespace sheetmorph::surface
{

namespace
{

constexpr int most_rounds = 60;  // chosen, not measured: a limit for sheets that do not converge

// Limit of a step at convergence, relative to the size. Chosen: 0.01 micrometres of a blank of 1 m.
// Newton's method squares the error, so the last step leaves much less.
constexpr double settled = 1e-8;

void require_sheet(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table)
{
    if (mesh::connected_components(mesh).count != 1)
        throw InvalidInput("the sheet is in pieces", "lay them flat one by one");
    for (int edge = 0; edge < table.count(); ++edge)
        if (table.uses(edge).count() > 2)
            throw InvalidInput(
                "three triangles meet in one edge (a T-joint), which no flat sheet has",
                "cut it "
                "into parts there");
    if (mesh::boundary_edges(mesh).empty())
        throw InvalidInput("the sheet is closed, so that it cannot be laid flat", "cut it open");
}

void require_rims(const FlatInput& input)
{
    std::vector<char> is_taken(at(input.mesh.vertex_count()), 0);
    for (std::size_t rim = 0; rim < input.rims.size(); ++rim)
        for (const int vertex : input.rims[rim])
        {
            if (vertex < 0 || vertex >= input.mesh.vertex_count())
                throw InvalidInput("rim " + std::to_string(rim) + " names vertex "
                                   + std::to_string(vertex) + ", the sheet has "
                                   + std::to_string(input.mesh.vertex_count()));
            if (is_taken[at(vertex)])
                throw InvalidInput("vertex " + std::to_string(vertex) + " is in rims twice",
                                   "let each be in one, once");
            is_taken[at(vertex)] = 1;
        }
}

void require_neutral(const FlatInput& input)
{
    const Eigen::Index count = input.factors.size();
    if (count == 0 && input.directions.rows() == 0)
        return;
    if (count != input.mesh.triangle_count() || input.directions.rows() != count)
        throw InvalidInput("a neutral fibre takes a direction and a factor for each of the "
                           + std::to_string(input.mesh.triangle_count()) + " triangles, not "
                           + std::to_string(input.directions.rows()) + " and "
                           + std::to_string(count));
    if (!input.directions.allFinite() || !input.factors.allFinite()
        || !(input.factors.array() > 0.0).all())
        throw InvalidInput("directions and factors of a neutral fibre are finite, factors above 0");
}

// The stress-free shape of each triangle in the plane: as at rest, stretched along the neutral
// fibre.
std::vector<FlatTriangle> triangles_of(const mesh::TriangleMesh& mesh, const FlatInput& input)
{
    std::vector<FlatTriangle> found;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        if (mesh::is_thin(mesh.points(), mesh.triangles(), t))
            continue;
        const auto ids = mesh.triangles().row(t);
        const Vector3 first = mesh.points().row(ids(0)).transpose();
        const Vector3 one = mesh.points().row(ids(1)).transpose() - first;
        const Vector3 other = mesh.points().row(ids(2)).transpose() - first;
        const Vector3 normal = one.cross(other).normalized();
        Eigen::Matrix<double, 2, 3> axes;
        axes << one.normalized().transpose(), normal.cross(one.normalized()).transpose();
        Eigen::Matrix2d sides;
        sides << axes * one, axes * other;
        if (input.factors.size() > 0 && input.factors(t) != 1.0)
        {
            const Eigen::Vector2d along =
                (axes * input.directions.row(t).transpose()).stableNormalized();
            sides += (input.factors(t) - 1.0) * along * (along.transpose() * sides);
        }
        const Eigen::Matrix2d inverse = sides.inverse();
        FlatTriangle triangle{t, {ids(0), ids(1), ids(2)}, {}, 0.5 * std::abs(sides.determinant())};
        triangle.gradients << -inverse.colwise().sum(), inverse;
        found.push_back(triangle);
    }
    return found;
}

// Two vertices with nearly the largest distance. Pinning them determines position, rotation and
// scale of the conformal map.
std::array<int, 2> farthest_pair(const mesh::TriangleMesh& mesh,
                                 const std::vector<FlatTriangle>& all)
{
    const auto farthest_from = [&](const Vector3& place)
    {
        int best = all.front().corners[0];
        double longest = -1.0;
        for (const FlatTriangle& triangle : all)
            for (const int corner : triangle.corners)
                if (const double distance = (mesh.points().row(corner).transpose() - place).norm();
                    distance > longest)
                {
                    longest = distance;
                    best = corner;
                }
        return best;
    };
    const int one = farthest_from(mesh.points().row(all.front().corners[0]).transpose());
    return {one, farthest_from(mesh.points().row(one).transpose())};
}

//! Unknowns u, v of every vertex except two pinned ones.
struct ConformalProblem
{
    numerics::SparseMatrix rows;  // (2 m, 2 n)
    std::vector<int> unknowns;    // (2 n), -1: pinned or unused
    int count = 0;
};

ConformalProblem conformal_problem(const mesh::TriangleMesh& mesh,
                                   const std::vector<FlatTriangle>& all,
                                   const std::array<int, 2>& pinned)
{
    ConformalProblem problem;
    problem.unknowns.assign(2 * at(mesh.vertex_count()), -1);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t t = 0; t < all.size(); ++t)
    {
        const double weight = std::sqrt(all[t].area);
        const int row = static_cast<int>(2 * t);
        for (int k = 0; k < 3; ++k)
        {
            const int u = 2 * all[t].corners[at(k)];
            const double a = weight * all[t].gradients(k, 0), b = weight * all[t].gradients(k, 1);
            // Cauchy-Riemann equations: u_x = v_y and u_y = -v_x.
            entries.emplace_back(row, u, a);
            entries.emplace_back(row, u + 1, -b);
            entries.emplace_back(row + 1, u, b);
            entries.emplace_back(row + 1, u + 1, a);
            problem.unknowns[at(u)] = problem.unknowns[at(u + 1)] = 0;
        }
    }
    for (const int vertex : pinned)
        problem.unknowns[at(2 * vertex)] = problem.unknowns[at(2 * vertex + 1)] = -1;
    for (int& unknown : problem.unknowns)
        if (unknown == 0)
            unknown = problem.count++;
    problem.rows.resize(static_cast<Eigen::Index>(2 * all.size()), 2 * mesh.vertex_count());
    problem.rows.setFromTriplets(entries.begin(), entries.end());
    return problem;
}

double area_of(const FlatTriangle& triangle, const FlatPoints& positions)
{
    const Eigen::Vector2d first = positions.row(triangle.corners[0]).transpose();
    Eigen::Matrix2d sides;
    sides << positions.row(triangle.corners[1]).transpose() - first,
        positions.row(triangle.corners[2]).transpose() - first;
    return 0.5 * sides.determinant();
}

// Least squares conformal map, scaled to the area of the sheet.
FlatPoints conformal_map(const mesh::TriangleMesh& mesh, const std::vector<FlatTriangle>& all)
{
    const std::array<int, 2> pinned = farthest_pair(mesh, all);
    const ConformalProblem problem = conformal_problem(mesh, all, pinned);
    Eigen::VectorXd told = Eigen::VectorXd::Zero(2 * mesh.vertex_count());
    told(2 * pinned[1]) = (mesh.points().row(pinned[1]) - mesh.points().row(pinned[0])).norm();
    auto whole = std::make_shared<numerics::SparseMatrix>(
        numerics::own_product(problem.rows, Eigen::VectorXd::Ones(problem.rows.rows())));
    const Eigen::VectorXd right = -(*whole * told);
    Eigen::VectorXd sums(problem.count);
    Points places(told.size(), 3);
    for (Eigen::Index k = 0; k < told.size(); ++k)
    {
        places.row(k) = mesh.points().row(k / 2);
        if (problem.unknowns[at(k)] >= 0)
            sums(problem.unknowns[at(k)]) = right(k);
    }
    const auto tree = std::make_shared<const numerics::SeparatorTree>(
        numerics::nested_dissection(*whole, places));
    const Eigen::VectorXd found =
        numerics::SparseCholesky({whole, problem.unknowns, problem.count}, tree).solve(sums);
    FlatPoints positions(mesh.vertex_count(), 2);
    for (Eigen::Index k = 0; k < told.size(); ++k)
        positions(k / 2, k % 2) =
            problem.unknowns[at(k)] >= 0 ? found(problem.unknowns[at(k)]) : told(k);
    double now = 0.0, wanted = 0.0;
    for (const FlatTriangle& triangle : all)
    {
        now += std::abs(area_of(triangle, positions));
        wanted += triangle.area;
    }
    return positions * std::sqrt(wanted / now);
}

}  // namespace

Flattening flatten(const FlatInput& input, const Progress& progress)
{
    const mesh::EdgeTable table(input.mesh);
    require_sheet(input.mesh, table);
    require_rims(input);
    require_neutral(input);
    const mesh::Orientation orientation = mesh::consistent_orientation(input.mesh, table);
    if (!orientation.is_possible)
        throw InvalidInput("the sheet has one side only (a Moebius strip)", "cut it open");
    const mesh::TriangleMesh mesh = mesh::oriented(input.mesh, orientation);
    const std::vector<FlatTriangle> triangles = triangles_of(mesh, input);
    if (triangles.empty())
        throw InvalidInput("the sheet has no triangle with an area");
    progress.report(0.0, "laying flat");
    FlatSystem system(input, triangles, conformal_map(mesh, triangles));
    Flattening found;
    numerics::NewtonLimits limits{"the flat shape"};
    limits.most_rounds = most_rounds;
    limits.settled = settled * mesh.size();
    limits.finest = limits.settled;
    limits.models = 2;
    limits.task = "laying flat";
    found.convergence = numerics::newton_minimum(system, limits, progress);
    found.positions = system.positions();
    found.is_rigid = system.rigid_rims();
    found.turned = orientation.flipped;
    for (const FlatTriangle& triangle : triangles)
        if (area_of(triangle, found.positions) <= 0.0)
            found.flipped.push_back(triangle.index);
    progress.report(1.0, "laying flat");
    return found;
}

}  // namespace sheetmorph::surface
