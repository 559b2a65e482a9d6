// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <vector>

namespace sheetmorph::volume
{

//! Points in one pass over the control mesh, from the widest register of doubles.
constexpr int lanes = 8;

//! A closed triangle mesh as flat arrays, for the mean value kernel.
struct KernelMesh
{
    std::vector<double> vertices;        //!< 3 per vertex: x, y, z
    std::vector<int> edge_ends;          //!< 2 per edge
    std::vector<double> edge_vectors;    //!< 3 per edge: second end minus first end
    std::vector<int> triangle_vertices;  //!< 3 per triangle
    std::vector<int> triangle_edges;     //!< 3 per triangle: the edge opposite to each vertex
    std::vector<double> edge_signs;  //!< 3 per triangle: -1 for an edge that it traverses backwards

    //! Data that make the weights affine to the last digit; see finish() of the kernel.
    double centre[3] = {0.0, 0.0, 0.0};
    std::vector<double> arms;    //!< 3 per vertex: from the centre
    std::vector<double> affine;  //!< 3 per vertex: smallest weights per unit of a vector

    int vertex_count() const { return static_cast<int>(vertices.size() / 3); }
    int edge_count() const { return static_cast<int>(edge_ends.size() / 2); }
    int triangle_count() const { return static_cast<int>(triangle_vertices.size() / 3); }
};

//! \throws InvalidInput unless every edge has two triangles that traverse it in opposite directions
KernelMesh kernel_mesh(const Points& vertices, const Triangles& triangles);

//! One number for each point of a block.
struct alignas(64) LaneValues
{
    double at[lanes];
};

//! Vectors, one for each point: entry k of each array is one vector.
struct LaneVectors
{
    explicit LaneVectors(int count) : x(count), y(count), z(count) {}
    std::vector<LaneValues> x, y, z;
};

//! Work space and results for `lanes` points.
struct KernelBlock
{
    explicit KernelBlock(const KernelMesh& mesh);

    //! A point that is too near to a triangle's plane; the kernel skips this triangle.
    struct Grazed
    {
        int triangle, lane;
    };

    LaneVectors points;                        //!< one entry
    LaneVectors unit;                          //!< per vertex: direction from the point
    LaneVectors cross;                         //!< per edge: product of its directions
    std::vector<LaneValues> inverse_distance;  //!< per vertex
    std::vector<LaneValues> half_angle_ratio;  //!< per edge: theta / (2 sin theta)
    std::vector<LaneValues> weights;           //!< per vertex; after add_up(): times the distance
    std::vector<Grazed> grazed;
};

//! Computes the mean value weights (2.12, 2.13) of block.points in vector form (mathematics.md,
//! section 5), times the distances and not normalised. Uses the widest instructions of the
//! processor.
void add_up(const KernelMesh& mesh, KernelBlock& block);

//! Divides by the distances, normalises, and restores affine precision to rounding by the smallest
//! correction. All weights are equal if the sum has no accurate digit. That happens millions of
//! sizes away, and possibly on the zero set outside a strongly non-convex mesh.
void finish(const KernelMesh& mesh, KernelBlock& block);

}  // namespace sheetmorph::volume
