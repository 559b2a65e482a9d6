// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"
#include "sheetmorph/mesh/search/part_geometry.h"
#include "sheetmorph/volume/rotations/rotation_kernel.h"

#include <vector>

namespace sheetmorph::volume
{

//! How the surface turned at some vertices.
struct LocalRotations
{
    std::vector<Matrix3> matrices;  //!< k rotations
    Points logs;                    //!< (k, 3), each near its reference
    Points tilts = Points(0, 3);    //!< (k, 3) what logs cannot tell (log_near()); no rows: nothing
};

//! Measures how the one-rings of some vertices turn: polar factor of the map from the rest ring to
//! the deformed one, completed by the normal. The constructor prepares, measure() is per frame.
class LocalRotationMeter
{
public:
    //! \throws InvalidInput naming the ids that the mesh does not have
    LocalRotationMeter(const mesh::TriangleMesh& rest, const VertexIds& vertices);

    //! The same of a part that others read too; neither is kept.
    LocalRotationMeter(const mesh::PartGeometry& rest, const VertexIds& vertices);

    //! A vertex in no triangle, or in degenerate ones only, turns as its reference says. So does,
    //! to the bit, a ring that the reference's rotation alone explains.
    //! \param deformed    (n, 3) mm: the whole mesh
    //! \param references  (k, 3) logs, such as the interpolated rotation field at the vertices
    LocalRotations measure(const Points& deformed, const Points& references) const;

    //! The same without logs, for live frames: what a ring tells does not depend on its reference
    //! but by rounding, so that references are read only for the vertices of without_ring();
    //! without any of them they may be empty.
    std::vector<Matrix3> matrices(const Points& deformed, const Points& references) const;

    //! The vertices, of those given, that turn as their reference says.
    VertexIds without_ring() const;

    //! The vertices whose positions are measured.
    const VertexIds& reads() const { return reads_; }

private:
    RingBatch& open_batch(int vertex, std::size_t spokes);
    void add_ring(const Points& rest, int vertex, std::vector<int> sides);
    void make_compact(const Points& rest);
    bool tells(std::size_t ring) const;
    Points of_reads(const Points& points) const;
    void require_rows(const Points& deformed, const Points& references, std::size_t wanted) const;
    void turn(const Points& deformed, std::vector<Matrix3>& references) const;

    int vertex_count_;
    std::size_t count_ = 0;  // of rings
    std::vector<RingBatch> batches_;
    std::vector<RingSpokes> spokes_;
    VertexIds reads_;  // rows of rest_; rings count by them
    Points rest_;
    bool needs_references_ = false;
};

//! The motion of a whole region: its rotation is that of the mean of the local logs, so that it
//! follows a handle through whole turns (a best fit of the points jumps, and points on a line have
//! none), tilted by the mean of what those logs cannot tell near a whole turn (tilt_beyond()); its
//! translation takes centroid to centroid.
//! \param rest, deformed  (k, 3) mm
//! \param weights         k, >= 0, such as vertex areas; empty for equal ones
RigidMotion mean_motion(const Points& rest, const Points& deformed, const LocalRotations& turned,
                        const Eigen::VectorXd& weights = {});

}  // namespace sheetmorph::volume
