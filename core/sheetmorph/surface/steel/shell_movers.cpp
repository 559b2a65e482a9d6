// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/steel/shell_movers.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/mesh/geometry/thinness.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

using Kind = ShellMover::Kind;

constexpr int loose = -1;  // not part of a rigid object
constexpr int ground = 0;  // fixed
constexpr int kinds = 4;   // of rigid objects, for unique indices; from the code below

Vector3 row_of(const Points& points, int row)
{
    return points.row(row).transpose();
}

Vector3 normal_of(const Points& points, const std::array<int, 3>& corners)
{
    const Vector3 first = row_of(points, corners[0]);
    return (row_of(points, corners[1]) - first)
        .cross(row_of(points, corners[2]) - first)
        .normalized();
}

Vector3 across(const Vector3& vector, const Vector3& direction)
{
    const Vector3 rest = vector - vector.dot(direction) * direction;
    return rest.norm() > 1e-9 ? Vector3(rest.normalized()) : direction.unitOrthogonal();
}

// The rigid object of a vertex: ground, handle, body or propagated region.
int rigid_with(const PlacementInput& part, int vertex)
{
    const int owner = part.roles.owner[at(vertex)];
    switch (part.roles.role[at(vertex)])
    {
        case Role::fixed:
            return ground;
        case Role::handle:
            return kinds * owner + 1;
        case Role::propagated:
            return kinds * owner + 2;
        case Role::body:
        {
            const Body& body = part.roles.bodies[at(owner)];
            if (body.motion == Body::Motion::fixed)
                return ground;
            return body.motion == Body::Motion::handle ? kinds * body.driver + 1
                                                       : kinds * owner + 3;
        }
        default:
            return loose;
    }
}

//! Determines the unknowns of vertices and edges in one pose.
class Deciding
{
public:
    Deciding(const ShellMesh& mesh, const ShellPose& pose, const std::vector<Turner>& turners,
             ShellMovers& found)
        : mesh_(mesh), pose_(pose), found_(found), rigid_(at(pose.part.rest.vertex_count()))
    {
        for (int i = 0; i < pose.part.rest.vertex_count(); ++i)
            rigid_[at(i)] = rigid_with(pose.part, i);
        turner_of_body_.assign(pose.part.roles.bodies.size(), -1);
        for (std::size_t k = 0; k < turners.size(); ++k)
            turner_of_body_[at(turners[k].body)] = static_cast<int>(k);
    }

    void run()
    {
        hold_turned_points();
        hold_around_single_vertices();
        move_vertices();
        turn_edges();
    }

private:
    Matrix3 rotation_at(int vertex) const
    {
        return rotation_from_log(pose_.logs.row(vertex).transpose());
    }

    // A point with a prescribed rotation moves the free corners of its triangle.
    void hold_turned_points()
    {
        const std::vector<PointConstraint>& points = pose_.part.constraints.points;
        found_.is_point_held.assign(points.size(), 1);
        for (std::size_t k = 0; k < points.size(); ++k)
        {
            if (!points[k].is_turned)
                continue;
            const auto corners = pose_.part.rest.triangles().row(points[k].triangle);
            if (std::any_of(corners.begin(), corners.end(),
                            [this](int corner) { return rigid_[at(corner)] != loose; }))
                continue;
            found_.is_point_held[k] = 0;
            const Matrix3 rotation = rotation_from_log(pose_.targets.points[k].rotation_log);
            const Points& rest = pose_.part.rest.points();
            Vector3 place = Vector3::Zero();
            for (int c = 0; c < 3; ++c)
                place += points[k].barycentric(c) * row_of(rest, corners(c));
            for (int c = 0; c < 3; ++c)
            {
                hold(corners(c), rotation,
                     pose_.targets.points[k].position
                         + rotation * (row_of(rest, corners(c)) - place));
                rigid_[at(corners(c))] = kinds * (next_region_ + static_cast<int>(k)) + 2;
            }
        }
    }

    void hold(int vertex, const Matrix3& rotation, const Vector3& position)
    {
        found_.start.positions.row(vertex) = position.transpose();
        held_rotations_.emplace_back(vertex, rotation);
    }

    // A single prescribed vertex does not fix the slope, so the free vertices around it move
    // rigidly with it.
    void hold_around_single_vertices()
    {
        const std::vector<int> given = rigid_;
        std::vector<char> is_single(given.size(), 0);
        for (std::size_t i = 0; i < given.size(); ++i)
            is_single[i] = given[i] != loose && is_known(static_cast<int>(i));
        for (const std::array<int, 2>& edge : mesh_.edges)
            if (given[at(edge[0])] == given[at(edge[1])])
                is_single[at(edge[0])] = is_single[at(edge[1])] = 0;
        for (const std::array<int, 2>& edge : mesh_.edges)
            for (const int side : {0, 1})
            {
                const int one = edge[at(side)], other = edge[at(1 - side)];
                if (!is_single[at(one)] || rigid_[at(other)] != loose)
                    continue;
                const Points& rest = pose_.part.rest.points();
                const Matrix3 rotation = rotation_at(one);
                hold(other, rotation,
                     row_of(pose_.positions, one)
                         + rotation * (row_of(rest, other) - row_of(rest, one)));
                rigid_[at(other)] = given[at(one)];
            }
    }

    bool is_known(int vertex) const
    {
        const int owner = pose_.part.roles.owner[at(vertex)];
        return pose_.part.roles.role[at(vertex)] != Role::body
               || pose_.part.roles.bodies[at(owner)].is_known();
    }

    void move_vertices()
    {
        std::vector<char> is_used(rigid_.size(), 0);
        for (const ShellMesh::Triangle& triangle : mesh_.triangles)
            for (const int corner : triangle.corners)
                is_used[at(corner)] = 1;
        found_.vertices.resize(rigid_.size());
        for (std::size_t i = 0; i < rigid_.size(); ++i)
        {
            ShellMover& mover = found_.vertices[i];
            if (pose_.part.roles.role[i] == Role::body)
            {
                const int turner = turner_of_body_[at(pose_.part.roles.owner[i])];
                if (turner >= 0)
                    mover = {Kind::joint, turner};
            }
            else if (rigid_[i] == loose && is_used[i])
            {
                mover = {Kind::open, found_.open};
                found_.open += 3;
            }
        }
    }

    // An edge between two vertices of the same rigid object rotates with it.
    void turn_edges()
    {
        std::vector<char> is_active(mesh_.edges.size(), 0);
        for (const ShellMesh::Triangle& triangle : mesh_.triangles)
            for (int k = 0; k < 3; ++k)
                is_active[at(triangle.edges[at(k)])] = 1;
        found_.edges.resize(mesh_.edges.size());
        found_.start.directors = mesh_.directors;
        for (std::size_t e = 0; e < mesh_.edges.size(); ++e)
        {
            const auto [a, b] = mesh_.edges[e];
            if (rigid_[at(a)] == loose || rigid_[at(a)] != rigid_[at(b)])
            {
                found_.edges[e] = {is_active[e] ? Kind::open : Kind::known, found_.open};
                found_.open += is_active[e];
            }
            else if (found_.vertices[at(a)].kind == Kind::joint)
                found_.edges[e] = found_.vertices[at(a)];
        }
        place_directors();
    }

    void place_directors()
    {
        std::vector<Vector3> sums(mesh_.edges.size(), Vector3::Zero());
        std::vector<Vector3> known(mesh_.edges.size(), Vector3::Zero());
        for (const ShellMesh::Triangle& triangle : mesh_.triangles)
            for (int k = 0; k < 3; ++k)
            {
                const int edge = triangle.edges[at(k)];
                const Vector3 director = carried(triangle, edge);
                sums[at(edge)] += director;
                const bool is_whole = std::all_of(
                    triangle.corners.begin(), triangle.corners.end(),
                    [&](int corner) { return found_.vertices[at(corner)].kind == Kind::known; });
                if (is_whole)
                    known[at(edge)] += director;
            }
        std::vector<Matrix3> turned(at(pose_.part.rest.vertex_count()));
        for (std::size_t i = 0; i < turned.size(); ++i)
            turned[i] = rotation_at(static_cast<int>(i));
        for (const auto& [vertex, rotation] : held_rotations_)
            turned[at(vertex)] = rotation;
        for (std::size_t e = 0; e < mesh_.edges.size(); ++e)
        {
            const auto [a, b] = mesh_.edges[e];
            const Vector3 direction = mesh_.direction(found_.start.positions, static_cast<int>(e));
            const bool is_told = found_.edges[e].kind != Kind::open;
            Vector3 wanted = sums[e];
            if (is_told)
                wanted = known[e].isZero(0.0)
                             ? Vector3((turned[at(a)] + turned[at(b)]) * mesh_.directors[e])
                             : known[e];
            found_.start.directors[e] = across(wanted, direction);
        }
    }

    // The director of an edge, moved rigidly with one of its triangles.
    Vector3 carried(const ShellMesh::Triangle& triangle, int edge) const
    {
        const Points& rest = pose_.part.rest.points();
        const Points& now = found_.start.positions;
        const Vector3 before = normal_of(rest, triangle.corners);
        const Vector3 after = normal_of(now, triangle.corners);
        const Vector3 along = mesh_.direction(rest, edge);
        const Vector3 direction = mesh_.direction(now, edge);
        const Vector3& director = mesh_.directors[at(edge)];
        return director.dot(before) * after
               + director.dot(along.cross(before)) * direction.cross(after);
    }

    const ShellMesh& mesh_;
    const ShellPose& pose_;
    ShellMovers& found_;
    std::vector<int> rigid_;
    std::vector<int> turner_of_body_;
    std::vector<std::pair<int, Matrix3>> held_rotations_;
    int next_region_ = static_cast<int>(pose_.part.constraints.propagated.size());
};

}  // namespace

ShellMesh::ShellMesh(const mesh::TriangleMesh& mesh)
{
    const mesh::EdgeTable table(mesh);
    edges.resize(at(table.count()));
    directors.assign(edges.size(), Vector3::Zero());
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        if (mesh::is_thin(mesh.points(), mesh.triangles(), t) || table.edge_of(t, 0) < 0)
            continue;
        const auto corners = mesh.triangles().row(t);
        Triangle triangle{t, {corners(0), corners(1), corners(2)}, {}, {}};
        for (int k = 0; k < 3; ++k)
        {
            const int a = corners(k), b = corners((k + 1) % 3);
            const int edge = table.edge_of(t, k);
            triangle.edges[at(k)] = edge;
            triangle.signs[at(k)] = a < b ? 1.0 : -1.0;
            edges[at(edge)] = {std::min(a, b), std::max(a, b)};
            if (directors[at(edge)].isZero(0.0))
                directors[at(edge)] = normal_of(mesh.points(), triangle.corners);
        }
        triangles.push_back(triangle);
    }
}

Vector3 ShellMesh::direction(const Points& points, int edge) const
{
    const auto [a, b] = edges[at(edge)];
    const Vector3 along = row_of(points, b) - row_of(points, a);
    const double length = along.norm();
    return length > 0.0 ? Vector3(along / length) : Vector3(Vector3::UnitX());
}

ShellMovers::ShellMovers(const ShellMesh& mesh, const ShellPose& pose, const Joints& joints,
                         const std::vector<Turner>& turners)
{
    start.positions = pose.positions;
    start.bodies = joints.states();
    Deciding(mesh, pose, turners, *this).run();
}

std::vector<Turner> shell_turners(const PlacementInput& part)
{
    std::vector<Turner> turners;
    for (const int index : leaders_first(part.roles.bodies))
    {
        const Body& body = part.roles.bodies[at(index)];
        if (!body.is_known())
            turners.push_back({index, -1, body.motion == Body::Motion::free, body.is_bound,
                               body.vertices, body.is_open()});
    }
    return turners;
}

}  // namespace sheetmorph::surface
