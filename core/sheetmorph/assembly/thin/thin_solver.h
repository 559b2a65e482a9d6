// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/system/system.h"
#include "sheetmorph/assembly/thin/thin_reduction.h"
#include "sheetmorph/assembly/thin/thin_sizes.h"
#include "sheetmorph/surface/surface_deformer.h"
#include "sheetmorph/volume/local_rotations.h"

namespace sheetmorph::assembly
{

//! A thin part and what the whole assembly says about it.
struct ThinSolverInput
{
    std::shared_ptr<const ThinPart> part;
    const Assembly& whole;  //!< with_lumps(); only read during construction
    const System& system;   //!< of the reduced assembly; likewise
    int index = 0;          //!< of the part
};

//! From the middle of a thin part to all its vertices. A vertex of a fixed region, a handle, a
//! feature, a lump or a rigid contact moves with that, exactly; every other hangs on the middle:
//!   p = p_hat + sum_j beta_j (p_j - p_hat_j) + (R - 1) (p_hat - q_hat)
//!       + 1/2 sum_j beta_j R_j (q_hat - p_hat_j),
//! q_hat its place on the middle (of several equally near ones the mean of what they give), R_j the
//! local rotations there (polar factors of one-rings; those of handles and features on them), R
//! their mean. The last term is how far the skin curves
//! out of its facet; without the half the sheet would be too thick by the same amount.
class ThinSolver
{
public:
    explicit ThinSolver(const ThinSolverInput& input);

    //! The middle in one pose. Points lie off it; they are met by a few repeated solves.
    surface::Deformation solve(const surface::SurfaceDeformer& deformer,
                               const surface::SurfaceTargets& targets, Exactness exactness,
                               const Progress& progress = {}) const;

    //! Whether points hold or move the part, so that one solve is not enough.
    bool has_points() const { return !points_.empty(); }

    //! All vertices for a middle, with rotation logs if exact.
    //! \param targets  handles and sizes of the part's own (Owner)
    //! \param whole    filled; its memory is used again
    void expand(const surface::Deformation& middle, const surface::SurfaceTargets& targets,
                Exactness level, surface::Deformation& whole) const;

    //! The vertices of the middle whose rotation logs expand() reads in live frames.
    VertexIds read_logs() const;

private:
    //! What moves a vertex: the sheet it hangs on, the ground, a handle or a feature.
    struct Mover
    {
        enum class Kind : char
        {
            sheet,
            ground,
            handle,
            feature
        };
        Kind kind = Kind::sheet;
        int index = -1;
    };
    struct PlacedPoint
    {
        std::size_t index;
        mesh::Anchor place;  // of the whole mesh
    };
    using Movers = std::vector<Mover>;
    using Regions = std::vector<VertexIds>;

    void find_movers(const ThinSolverInput& input);
    void find_middle_movers(const Owner& owner, const Sheet& sheet);
    void find_points(const ThinSolverInput& input);
    static void set_movers(Movers& movers, const Regions& regions, Mover::Kind kind);
    std::vector<RigidMotion> known_handles(const surface::Deformation& middle,
                                           std::vector<RigidMotion> handles) const;
    volume::LocalRotations rotations(const surface::Deformation& middle,
                                     const std::vector<RigidMotion>& handles,
                                     Exactness level) const;
    struct BentMiddle
    {
        const surface::Deformation& middle;
        const volume::LocalRotations& turned;  // without logs unless exact
        const std::vector<RigidMotion>& handles;
        const Points& rest;  // of the whole part, sized features with their sizes
    };
    struct Hung
    {
        Vector3 shift;
        Vector3 log;
    };
    std::vector<Matrix3> means(int begin, int end, const BentMiddle& bent) const;
    Hung hung(int vertex, const mesh::Anchor& anchor, const Matrix3& mean,
              const BentMiddle& bent) const;
    void hang(int vertex, const Matrix3* means, const BentMiddle& bent,
              surface::Deformation& whole) const;
    void place(int begin, int end, const BentMiddle& bent, surface::Deformation& whole) const;
    void carry(int vertex, const RigidMotion& motion, const BentMiddle& bent,
               surface::Deformation& whole) const;
    double ask_for_missing(const surface::Deformation& whole,
                           const surface::SurfaceTargets& targets,
                           surface::SurfaceTargets& asked) const;

    std::shared_ptr<const ThinPart> part_;
    Movers movers_, middle_movers_;        // by vertex of the whole part, of the middle
    std::vector<VertexIds> free_handles_;  // by handle: its middle vertices if the energy turns it
    // Of the bodies of the whole part: its own features and the welds that are bodies of its sheet.
    // They are the first bodies of the middle, which has more: held welds, loose pieces.
    std::vector<Vector3> centres_;
    ThinSizes sizes_;
    std::vector<PlacedPoint> points_;
    volume::LocalRotationMeter meter_;  // of every vertex of the middle
};

}  // namespace sheetmorph::assembly
