// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/noise.h"

#include "sheetmorph/mesh/geometry/areas.h"
#include "sheetmorph/mesh/geometry/thinness.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sheetmorph::mesh
{

namespace
{

// Cosine of the largest angle between neighbours in smooth regions, 50 degrees. Chosen: below the
// bend at an edge of a box, and twice the standard deviation (23 degrees) of the bends that a
// scatter of a fifth of an edge makes.
constexpr double smooth = 0.64;

// Lower quartile of |x| for a standard normal variable x, from its distribution; converts the
// quartile of residuals to a standard deviation.
constexpr double calm_quarter = 0.3186;

// Number of sampled vertices. From statistics: the quartile of 1000 values is exact to 6 %.
constexpr std::size_t most_places = 1000;

// Fewest usable vertices. From statistics: the quartile of 12 values is exact to a factor of 1.5.
constexpr std::size_t fewest_places = 12;

// The neighbours must determine the quadric, which has six coefficients. Chosen: half as many more.
constexpr Eigen::Index fewest_neighbours = 9;

// Determinant of their covariance over its squared trace. From geometry: widths w and 1 give
// w^2 / (1 + w^2)^2, so points may be seven times as long as wide.
constexpr double slimmest = 0.02;

// Share of a vertex in its own fitted height. Chosen: its residual is divided by the root of the
// rest, so it grows by 2.2 at the limit.
constexpr double most_leverage = 0.8;

// A smaller scatter relative to the median edge length counts as none. From geometry: on a cylinder
// without noise, terms of fourth order look like a scatter of 0.005 of an edge at 10 degrees per
// edge and 0.018 at 15 degrees (computed for a vertex with two regular rings). Chosen between the
// two. Measured: at 0.004, Noise.DrawnMeshesHaveNoScatterHoweverTheyBend sees scatter; at 0.016,
// Noise.ScatterOfMeasuredMeshesIsToldToAHalf misses some.
constexpr double least = 0.008;

// Standard deviation of a triangle's normal, times height, over that of its vertices. From error
// propagation: the apex counts once and the foot, between two corners, a half: sqrt(1 + 1/2).
constexpr double of_normal = 1.22;

// Passes of the filter of normals, and the bend that it always treats as smooth, radians. Chosen:
// 12 passes average over about three triangles in every direction (the root of their number); 6
// degrees is the largest bend inside a plane (FeatureTolerances::plane_angle).
constexpr int rounds = 12;
constexpr double alike = 0.1;

// Neighbours along edges; empty for a vertex whose triangles bend strongly.
class SmoothNeighbours
{
public:
    SmoothNeighbours(const TriangleMesh& mesh, const EdgeTable& edges, const Points& normals)
        : near_(static_cast<std::size_t>(mesh.vertex_count())),
          normals_(Points::Zero(mesh.vertex_count(), 3))
    {
        for (int e = 0; e < edges.count(); ++e)
        {
            const EdgeUse& use = *edges.uses(e).begin();
            near_[use.from].push_back(use.to);
            near_[use.to].push_back(use.from);
        }
        for (int e = 0; e < edges.count(); ++e)
        {
            const EdgeUses uses = edges.uses(e);
            const Eigen::RowVector3d one = normals.row(uses.begin()->triangle);
            normals_.row(uses.begin()->from) = one;
            normals_.row(uses.begin()->to) = one;
            const bool is_smooth =
                uses.count() == 1
                || (uses.count() == 2
                    && std::abs(one.dot(normals.row(uses.begin()[1].triangle))) > smooth);
            if (!is_smooth)
                near_[uses.begin()->from] = near_[uses.begin()->to] = {};
        }
    }

    // The vertex and its two rings; empty if a sharp bend is near.
    VertexIds patch(int vertex) const
    {
        VertexIds found = {vertex};
        std::size_t begin = 0;
        for (int ring = 0; ring < 2; ++ring)
        {
            const std::size_t end = found.size();
            for (; begin < end; ++begin)
            {
                if (near_[found[begin]].empty())
                    return {};
                for (const int other : near_[found[begin]])
                    if (std::abs(normals_.row(vertex).dot(normals_.row(other))) < smooth)
                        return {};
                    else if (std::find(found.begin(), found.end(), other) == found.end())
                        found.push_back(other);
            }
        }
        return found;
    }

    Vector3 normal(int vertex) const { return normals_.row(vertex).transpose(); }

private:
    std::vector<VertexIds> near_;
    Points normals_;  // by vertex: normal of one of its triangles
};

// Residual of a vertex from the quadric fitted to itself and its neighbours, normalised to the
// residual of unit scatter. Negative if the neighbours do not determine the quadric.
double left_of(const Points& patch, const Vector3& normal)
{
    if (patch.rows() < fewest_neighbours + 1)
        return -1.0;
    const Vector3 across = normal.unitOrthogonal();
    const Points off = patch.rowwise() - patch.row(0);
    const Eigen::ArrayXd x = off * across;
    const Eigen::ArrayXd y = off * normal.cross(across);
    const double size = std::sqrt((x.square() + y.square()).maxCoeff());
    const Eigen::Array3d spread((x * x).sum(), (y * y).sum(), (x * y).sum());
    if (spread(0) * spread(1) - spread(2) * spread(2)
        < slimmest * std::pow(spread(0) + spread(1), 2))
        return -1.0;
    Eigen::Matrix<double, Eigen::Dynamic, 6> terms(patch.rows(), 6);
    terms << Eigen::ArrayXd::Ones(patch.rows()), x / size, y / size, x * x / (size * size),
        x * y / (size * size), y * y / (size * size);
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factor(terms.transpose() * terms);
    const Eigen::VectorXd height = off * normal;
    const Eigen::Matrix<double, 6, 1> solved = factor.solve(terms.transpose() * height);
    const Eigen::Matrix<double, 6, 1> first = terms.row(0).transpose();
    const double leverage = first.dot(factor.solve(first));
    if (!(leverage < most_leverage) || !solved.allFinite())
        return -1.0;
    return std::abs(height(0) - first.dot(solved)) / std::sqrt(1.0 - leverage);
}

double quantile(std::vector<double>& values, double share)
{
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

}  // namespace

double scatter_of(const TriangleMesh& mesh, const EdgeTable& edges, const Points& normals)
{
    const SmoothNeighbours neighbours(mesh, edges, normals);
    const auto count = static_cast<std::size_t>(mesh.vertex_count());
    const std::size_t step = std::max<std::size_t>(1, count / most_places);
    std::vector<double> left;
    std::vector<double> lengths;
    for (std::size_t v = 0; v < count; v += step)
    {
        const VertexIds patch = neighbours.patch(static_cast<int>(v));
        if (patch.empty())
            continue;
        const Points points = mesh.points()(patch, Eigen::indexing::all);
        const double value = left_of(points, neighbours.normal(patch.front()));
        if (value < 0.0)
            continue;
        left.push_back(value);
        lengths.push_back((points.row(1) - points.row(0)).norm());
    }
    if (left.size() < fewest_places)
        return 0.0;
    const double scatter = quantile(left, 0.25) / calm_quarter;
    return scatter < least * quantile(lengths, 0.5) ? 0.0 : scatter;
}

double scatter_of(const TriangleMesh& mesh)
{
    Points normals = Points::Zero(mesh.triangle_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (!is_thin(mesh.points(), mesh.triangles(), t))
            normals.row(t) = doubled_area(mesh, t).normalized().transpose();
    return scatter_of(mesh, EdgeTable(mesh), normals);
}

std::vector<double> unsure_normals(const TriangleMesh& mesh, const std::vector<double>& areas,
                                   double scatter)
{
    std::vector<double> unsure(areas.size(), 0.0);
    for (std::size_t t = 0; t < areas.size(); ++t)
    {
        const Points corners =
            mesh.points()(mesh.triangles().row(static_cast<Eigen::Index>(t)), Eigen::indexing::all);
        const Points sides = corners({1, 2, 0}, Eigen::indexing::all) - corners;
        const double height = 2.0 * areas[t] / sides.rowwise().norm().maxCoeff();
        unsure[t] = areas[t] > 0.0 ? of_normal * scatter / height : 0.0;
    }
    return unsure;
}

Points calmed_normals(const EdgeTable& edges, const Points& normals,
                      const std::vector<double>& areas, const std::vector<double>& unsure)
{
    const Eigen::VectorXd area =
        Eigen::Map<const Eigen::VectorXd>(areas.data(), static_cast<Eigen::Index>(areas.size()));
    Points calm = normals;
    // A filter with a fixed number of passes; it does not iterate to convergence.
    for (int round = 0; round < rounds; ++round)
    {
        Points sums = area.asDiagonal() * calm;
        for (int e = 0; e < edges.count(); ++e)
        {
            const EdgeUses uses = edges.uses(e);
            if (uses.count() != 2)
                continue;
            const int a = uses.begin()[0].triangle;
            const int b = uses.begin()[1].triangle;
            const double same_way = uses.begin()[0].from != uses.begin()[1].from ? 1.0 : -1.0;
            const double apart = (calm.row(a) - same_way * calm.row(b)).squaredNorm();
            const double explained =
                alike * alike
                + 2.0 * (unsure[a] * unsure[a] + unsure[b] * unsure[b]) / (1.0 + round);
            const double weight = std::exp(-0.5 * apart / explained);
            sums.row(a) += weight * areas[b] * same_way * calm.row(b);
            sums.row(b) += weight * areas[a] * same_way * calm.row(a);
        }
        for (Eigen::Index t = 0; t < calm.rows(); ++t)
            if (area(t) > 0.0)
                calm.row(t) = sums.row(t).normalized();
    }
    return calm;
}

}  // namespace sheetmorph::mesh
