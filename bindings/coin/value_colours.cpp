// SPDX-License-Identifier: LGPL-2.1-or-later
#include "value_colours.h"

#include <Inventor/nodes/SoMaterial.h>

#include <algorithm>
#include <cmath>

#include "node_at.h"

namespace sheetmorph::coin
{

ValueColours::ValueColours(std::uintptr_t material, Colours ramp, Eigen::RowVector3f missing)
    : ramp_(std::move(ramp)), missing_(std::move(missing)), material_(node_at<SoMaterial>(material))
{
    if (ramp_.rows() < 2)
        throw std::invalid_argument("a ramp needs two colours at least");
    material_->ref();
}

ValueColours::~ValueColours()
{
    material_->unref();
}

void ValueColours::show(const Eigen::VectorXd& values, std::pair<double, double> span) const
{
    const auto [low, high] = span;
    const double scale = high > low ? static_cast<double>(ramp_.rows() - 1) / (high - low) : 0.0;
    SoMFColor& field = material_->diffuseColor;
    if (field.getNum() != values.size())
        field.setNum(static_cast<int>(values.size()));
    auto* colours = reinterpret_cast<float*>(field.startEditing());
    for (Eigen::Index k = 0; k < values.size(); ++k)
    {
        const bool is_known = std::isfinite(values(k));
        const double place = is_known ? std::max(0.0, (values(k) - low) * scale) : 0.0;
        const Eigen::Index row = std::min(ramp_.rows() - 1, std::lround(std::min(place, 1e6)));
        Eigen::Map<Eigen::RowVector3f>(colours + 3 * k) =
            is_known ? Eigen::RowVector3f(ramp_.row(row)) : missing_;
    }
    field.finishEditing();
}

}  // namespace sheetmorph::coin
