// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/fidelity.h"

#include "sheetmorph/assembly/links/control_box.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph::assembly
{

namespace
{

const mesh::TriangleMesh& mesh_of(const Assembly& assembly, int part)
{
    return assembly.parts[static_cast<std::size_t>(part)].mesh;
}

double diagonal(const Points& a, const Points& b)
{
    const Eigen::RowVector3d low = a.colwise().minCoeff().cwiseMin(b.colwise().minCoeff());
    const Eigen::RowVector3d high = a.colwise().maxCoeff().cwiseMax(b.colwise().maxCoeff());
    return (high - low).norm();
}

}  // namespace

ContactGauge::ContactGauge(const Assembly& assembly, const DirectedContact& contact)
    : source_(contact.source(assembly).vertices), target_(contact.target(assembly).vertices)
{
    blank_.contact = contact.contact;
    blank_.source_part = contact.source(assembly).part;
    blank_.target_part = contact.target(assembly).part;
    source_rest_ = rows_of(mesh_of(assembly, blank_.source_part).points(), source_);
    target_rest_ = rows_of(mesh_of(assembly, blank_.target_part).points(), target_);
    blank_.region_size = diagonal(source_rest_, target_rest_);
}

ContactFidelity ContactGauge::measure(const surface::Deformation& source,
                                      const Points& target) const
{
    ContactFidelity fidelity = blank_;
    const Vector3 mean_log = rows_of(source.rotation_logs, source_).colwise().mean().transpose();
    const RigidMotion own =
        best_rigid_motion_near(source_rest_, rows_of(source.positions, source_), mean_log);
    const Points expected = own.apply(target_rest_);
    for (std::size_t k = 0; k < target_.size(); ++k)
    {
        const Eigen::RowVector3d now = target.row(target_[k]);
        fidelity.deviation =
            std::max(fidelity.deviation, (now - expected.row(static_cast<Eigen::Index>(k))).norm());
    }
    return fidelity;
}

}  // namespace sheetmorph::assembly
