// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <vector>

namespace sheetmorph::volume
{

//! Points computed side by side in one pass over the control mesh.
constexpr int lanes = 8;

//! A closed triangle mesh as flat arrays, for the mean value kernel.
struct KernelMesh
{
    std::vector<double> vertices;        //!< 3 a vertex: x, y, z
    std::vector<int> edge_ends;          //!< 2 an edge
    std::vector<double> edge_vectors;    //!< 3 an edge: second end - first end
    std::vector<int> triangle_vertices;  //!< 3 a triangle
    std::vector<int> triangle_edges;     //!< 3 a triangle: the edge opposite to each vertex
    std::vector<double> edge_signs;  //!< 3 a triangle: -1 where it runs along the edge backwards

    //! What makes weights affine to the last digit: see finish() of the kernel.
    double centre[3] = {0.0, 0.0, 0.0};
    std::vector<double> arms;    //!< 3 a vertex: from the centre
    std::vector<double> affine;  //!< 3 a vertex: times a vector, the smallest weights of it

    int vertex_count() const { return static_cast<int>(vertices.size() / 3); }
    int edge_count() const { return static_cast<int>(edge_ends.size() / 2); }
    int triangle_count() const { return static_cast<int>(triangle_vertices.size() / 3); }
};

//! \throws InvalidInput unless every edge is shared by two triangles that run along it in
//! opposite directions
KernelMesh kernel_mesh(const Points& vertices, const Triangles& triangles);

//! One number for each of the points of a block.
struct alignas(64) LaneValues
{
    double at[lanes];
};

//! Coordinates of vectors, entry k of each array one vector for each point.
struct LaneVectors
{
    explicit LaneVectors(int count) : x(count), y(count), z(count) {}
    std::vector<LaneValues> x, y, z;
};

//! Scratch and results of `lanes` points.
struct KernelBlock
{
    explicit KernelBlock(const KernelMesh& mesh);

    //! A point too near to a triangle's plane for the kernel, which leaves the triangle out.
    struct Grazed
    {
        int triangle, lane;
    };

    LaneVectors points;                        //!< one
    LaneVectors unit;                          //!< a vertex: the direction from the point to it
    LaneVectors cross;                         //!< an edge: product of its ends' directions
    std::vector<LaneValues> inverse_distance;  //!< a vertex
    std::vector<LaneValues> half_angle_ratio;  //!< an edge: theta / (2 sin theta)
    std::vector<LaneValues> weights;           //!< a vertex; of add_up(): times the distance
    std::vector<Grazed> grazed;
};

//! The mean value weights (2.12, 2.13) of block.points, in vector form (mathematics.md, section 5),
//! times the distances, not normalised. Uses the widest instructions the processor has.
void add_up(const KernelMesh& mesh, KernelBlock& block);

//! Divides by the distances, normalises, and adds what rounding leaves of the affine precision as
//! the smallest correction; all alike where no digit is left of the sum, which happens millions of
//! sizes away, or on the zero set that a strongly non-convex mesh may have outside.
void finish(const KernelMesh& mesh, KernelBlock& block);

}  // namespace sheetmorph::volume
