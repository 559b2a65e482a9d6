// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/response/response_fields.h"
#include "sheetmorph/numerics/response/response_kernel.h"

namespace sheetmorph::numerics
{

//! Displacements that are linear in a few numbers: u = Phi c with a tall Phi (n, k) and c (k, 3). A
//! product reads Phi once, front to back, at the bandwidth of the memory. Fields of little
//! influence are stored in 16 bits, the others in float32.
class ResponseBasis
{
public:
    using Coefficients = ResponseFields::Coefficients;

    explicit ResponseBasis(const ResponseFields& fields = ResponseFields());

    //! result = start + Phi c, both (n, 3).
    void add_to(const Points& start, const Coefficients& coefficients, Points& result) const;

    Eigen::Index rows() const { return rows_; }
    Eigen::Index columns() const { return columns_; }

    //! Memory in bytes.
    double bytes() const;

private:
    struct Run  // rows with consecutive numbers
    {
        int first, count;
    };
    struct Place
    {
        std::size_t wide, narrow, shares, felt, runs;
        int wide_count, narrow_count, felt_count, run_count;
    };
    void find_runs(const VertexIds& rows);
    void pack(const ResponseFields::Patch& patch, const Eigen::VectorXd& tolerances);
    void add_patch(std::size_t patch, const Points& start, const Coefficients& coefficients,
                   Points& result) const;

    Eigen::Index rows_;
    Eigen::Index columns_;
    Eigen::Index rows_a_patch_;
    std::vector<Place> places_;       // of the patches
    std::vector<ResponseRows> wide_;  // block by block, a field each
    std::vector<NarrowRows> narrow_;  // likewise
    std::vector<float> shares_;       // of the columns felt
    std::vector<int> felt_;           // columns that move a patch
    std::vector<Run> runs_;
};

}  // namespace sheetmorph::numerics
