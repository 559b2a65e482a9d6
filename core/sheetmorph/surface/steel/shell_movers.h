// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"
#include "sheetmorph/surface/bodies/joints.h"

namespace sheetmorph::surface
{

//! The unknowns that move a vertex or rotate the director of an edge in the minimisation of a
//! shell.
struct ShellMover
{
    enum class Kind : char
    {
        known,  //!< prescribed: does not move
        open,   //!< has unknowns of its own
        joint   //!< moves rigidly with a body of Joints
    };

    Kind kind = Kind::known;
    int index = -1;  //!< its first unknown, or the index of the rotating body
};

//! A shell in one shape.
struct ShellShape
{
    Points positions;                //!< (n, 3) mm
    std::vector<Vector3> directors;  //!< (edges) unit, at right angles to their edges
    std::vector<BodyState> bodies;   //!< of the joints
};

//! The non-degenerate triangles of a part, and their edges, each with a director at rest.
struct ShellMesh
{
    explicit ShellMesh(const mesh::TriangleMesh& mesh);

    struct Triangle
    {
        int index;                    //!< in the mesh
        std::array<int, 3> corners;   //!< vertices
        std::array<int, 3> edges;     //!< edge k from corner k to the next
        std::array<double, 3> signs;  //!< 1 if the side starts at its smaller vertex, else -1
    };

    //! Unit vector from the smaller to the larger vertex.
    Vector3 direction(const Points& points, int edge) const;

    std::vector<Triangle> triangles;
    std::vector<std::array<int, 2>> edges;  //!< vertices, the smaller one first
    std::vector<Vector3> directors;         //!< (edges) at rest
};

//! One pose of a part with its linear solution.
struct ShellPose
{
    const PlacementInput& part;
    const SurfaceTargets& targets;
    const BodyMotions& bodies;  //!< full motions of all bodies
    const Points& positions;    //!< (n, 3)
    const Points& logs;         //!< (n, 3) rotations of the vertices
};

//! The unknowns of all vertices and edges, and the initial shape.
struct ShellMovers
{
    ShellMovers(const ShellMesh& mesh, const ShellPose& pose, const Joints& joints,
                const std::vector<Turner>& turners);

    std::vector<ShellMover> vertices;
    std::vector<ShellMover> edges;
    std::vector<char> is_point_held;  //!< by point: it needs a row; its triangle is not prescribed
    int open = 0;                     //!< unknowns before those of the joints
    ShellShape start;
};

//! The bodies that are unknowns of the shell, leaders before followers.
std::vector<Turner> shell_turners(const PlacementInput& part);

}  // namespace sheetmorph::surface
