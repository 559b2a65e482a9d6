// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"
#include "sheetmorph/surface/bodies/joints.h"

namespace sheetmorph::surface
{

//! What moves a vertex, or turns the director of an edge, while a shell is minimised.
struct ShellMover
{
    enum class Kind : char
    {
        known,  //!< nothing any more
        open,   //!< unknowns of its own
        joint   //!< a body of Joints, rigidly
    };

    Kind kind = Kind::known;
    int index = -1;  //!< its first unknown, or which of the turners
};

//! A shell in one shape.
struct ShellShape
{
    Points positions;                //!< (n, 3) mm
    std::vector<Vector3> directors;  //!< (edges) unit, at right angles to their edges
    std::vector<BodyState> bodies;   //!< of the joints
};

//! The triangles of a part that count, and their edges, each with a director at rest.
struct ShellMesh
{
    explicit ShellMesh(const mesh::TriangleMesh& mesh);

    struct Triangle
    {
        int index;                    //!< in the mesh
        std::array<int, 3> corners;   //!< vertices
        std::array<int, 3> edges;     //!< edge k from corner k to the next
        std::array<double, 3> signs;  //!< 1 where the side runs from the smaller vertex
    };

    //! Unit, from the smaller to the larger vertex.
    Vector3 direction(const Points& points, int edge) const;

    std::vector<Triangle> triangles;
    std::vector<std::array<int, 2>> edges;  //!< vertices, the smaller one first
    std::vector<Vector3> directors;         //!< (edges) at rest
};

//! One pose of a part, as the linear energy has answered it.
struct ShellPose
{
    const PlacementInput& part;
    const SurfaceTargets& targets;
    const BodyMotions& bodies;  //!< whole motions of all bodies
    const Points& positions;    //!< (n, 3)
    const Points& logs;         //!< (n, 3) rotations of the vertices
};

//! What moves everything, and the shape to start from.
struct ShellMovers
{
    ShellMovers(const ShellMesh& mesh, const ShellPose& pose, const Joints& joints,
                const std::vector<Turner>& turners);

    std::vector<ShellMover> vertices;
    std::vector<ShellMover> edges;
    std::vector<char> is_point_held;  //!< by point: its row is needed, its triangle is not known
    int open = 0;                     //!< unknowns before those of the joints
    ShellShape start;
};

//! Bodies that have to be found together with the shell, leaders before followers.
std::vector<Turner> shell_turners(const PlacementInput& part);

}  // namespace sheetmorph::surface
