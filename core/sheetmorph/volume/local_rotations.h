// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"
#include "sheetmorph/mesh/search/part_geometry.h"
#include "sheetmorph/volume/rotations/rotation_kernel.h"

#include <vector>

namespace sheetmorph::volume
{

//! Rotations of the surface at some vertices.
struct LocalRotations
{
    std::vector<Matrix3> matrices;  //!< k rotations
    Points logs;                    //!< (k, 3), each near its reference
    Points tilts = Points(0, 3);    //!< (k, 3) of tilt_beyond(); no rows: zeros
};

//! Measures the rotations of the one-rings of some vertices: polar factors of the maps from the
//! rest rings to the deformed ones, completed by the normals. The constructor does the set-up;
//! measure() runs per frame.
class LocalRotationMeter
{
public:
    //! \throws InvalidInput naming the ids that the mesh does not have
    LocalRotationMeter(const mesh::TriangleMesh& rest, const VertexIds& vertices);

    //! The same for geometry that is shared; keeps no reference to it.
    LocalRotationMeter(const mesh::PartGeometry& rest, const VertexIds& vertices);

    //! A vertex without a triangle, or with degenerate triangles only, has the rotation of its
    //! reference. So has, to the bit, a ring that the reference's rotation explains exactly.
    //! \param deformed    (n, 3) mm: the whole mesh
    //! \param references  (k, 3) logs, such as the interpolated rotation field at the vertices
    LocalRotations measure(const Points& deformed, const Points& references) const;

    //! The same without logs, for live frames. The rotation of a ring depends on its reference only
    //! by rounding, so only the vertices of without_ring() need a reference. If there are none,
    //! `references` may be empty.
    std::vector<Matrix3> matrices(const Points& deformed, const Points& references) const;

    //! The given vertices whose rotation is that of their reference.
    VertexIds without_ring() const;

    //! The vertices whose positions are read.
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
    std::size_t count_ = 0;  // number of rings
    std::vector<RingBatch> batches_;
    std::vector<RingSpokes> spokes_;
    VertexIds reads_;  // rows of rest_; rings refer to them
    Points rest_;
    bool needs_references_ = false;
};

//! The motion of a whole region. Its rotation is that of the mean of the local logs, so it follows
//! a handle through whole turns. (A best fit of the points jumps, and points on a line have none.)
//! The mean of the tilts that these logs miss near a whole turn is added (tilt_beyond()). The
//! translation takes centroid to centroid.
//! \param rest, deformed  (k, 3) mm
//! \param weights         (k), >= 0, such as vertex areas; empty for equal ones
RigidMotion mean_motion(const Points& rest, const Points& deformed, const LocalRotations& turned,
                        const Eigen::VectorXd& weights = {});

}  // namespace sheetmorph::volume
