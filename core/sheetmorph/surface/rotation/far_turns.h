// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/body_motions.h"
#include "sheetmorph/surface/operators/unknowns.h"
#include "sheetmorph/surface/rotation/rotation_field.h"

#include <mutex>
#include <optional>

namespace sheetmorph::surface
{

//! A rotation field with large rotations.
struct FarField
{
    Points logs;  //!< (n, 3) of the field
    Points rows;  //!< (r, 3) addition to the rows; no rows: rotations are not large
};

//! The curvature that large rotations give the sheet under `natural`. Rows of `natural` depend on
//! rotations only where the sheet is curved at rest, so a flat sheet would ignore full turns. For
//! large rotations the field becomes the harmonic one, which distributes a rotation evenly. It
//! determines a shape q = p_hat + d, and the sheet gets the rows of that shape:
//!   min_q sum_ij k_ij |(q_i - q_j) - R_ij (p_hat_i - p_hat_j)|^2 ,
//!   T = R D p_hat + b (D q - R D p_hat) .
//! Here k are the edge weights of the rotation field, and R_ij is half-way between the ends of an
//! edge. The share b grows smoothly from 0 to 1 while the given rotations of one component differ
//! by 60 to 120 degrees. A rigid motion of everything adds nothing.
class FarTurns
{
public:
    //! The first large rotation triggers the factorisation. Input and field must outlive the
    //! object.
    FarTurns(const RotationFieldInput& input, const RotationField& field);

    //! \param logs, tilts  (n, 3) of the rotation field
    FarField bent(const GivenRotations& given, Points logs, const Points& tilts) const;

    //! Whether bent() adds rows; for live frames.
    bool are_there(const SurfaceTargets& targets, const BodyMotions& bodies) const;

private:
    //! A given rotation and the component on which it acts.
    struct Source
    {
        enum class Kind : char
        {
            rest,
            handle,
            body,
            region,
            point
        };
        int component;
        Kind kind;
        int index;

        bool operator<(const Source& other) const;
    };
    struct Factor
    {
        explicit Factor(const SurfaceOperators& operators);

        Unknowns unknowns;
        numerics::SparseCholesky cholesky;
    };
    void find_sources();
    std::vector<double> shares(const GivenRotations& given) const;
    double share_at(const std::vector<double>& shares, int vertex) const;
    Points laid(const Points& logs, const Points& tilts) const;

    RotationFieldInput input_;
    const RotationField& field_;
    std::vector<Source> sources_;  // ordered by component
    mutable std::once_flag is_factorised_;
    mutable std::optional<Factor> factor_;
};

}  // namespace sheetmorph::surface
