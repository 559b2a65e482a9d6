// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>

#include "sheetmorph/base/types.h"

class SoMaterial;

namespace sheetmorph::coin
{

//! Colours, one a row: red, green, blue from 0 to 1.
using Colours = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

//! Shows one value a vertex as colours of a material, which it keeps alive.
class ValueColours
{
public:
    //! \param material  address of an SoMaterial that is bound PER_VERTEX_INDEXED
    //! \param ramp      (k, 3) colours from the low to the high end, k > 1
    //! \param missing   colour where there is no value
    //! \throws std::invalid_argument if the address is no SoMaterial, or the ramp too short
    ValueColours(std::uintptr_t material, Colours ramp, Eigen::RowVector3f missing);
    ~ValueColours();
    ValueColours(const ValueColours&) = delete;
    ValueColours& operator=(const ValueColours&) = delete;

    //! \param values  (n,), not a number where there is none
    //! \param span    values of the two ends; what lies outside has the colour of its end
    void show(const Eigen::VectorXd& values, std::pair<double, double> span) const;

private:
    Colours ramp_;
    Eigen::RowVector3f missing_;
    SoMaterial* material_;
};

}  // namespace sheetmorph::coin
