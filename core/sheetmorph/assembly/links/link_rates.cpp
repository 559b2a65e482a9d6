// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/links/link_rates.h"

#include "sheetmorph/assembly/links/control_box.h"

namespace sheetmorph::assembly
{

TurnedRates turned_rates(const volume::LocalRotationMeter& meter, const VertexIds& vertices,
                         const PartInMotion& part)
{
    const Points references = rows_of(part.shape.rotation_logs, vertices);
    const Points rates = rows_of(part.rate.rotation_logs, vertices);
    Points spins(references.rows(), 3);
    for (Eigen::Index k = 0; k < spins.rows(); ++k)
        spins.row(k) =
            spin_of_log(references.row(k).transpose(), rates.row(k).transpose()).transpose();
    TurnedRates found{meter.measure(part.shape.positions, references), {}, {}};
    found.spins = meter.spins(part.shape.positions, found.measured, part.rate.positions, spins);
    found.logs.resize(spins.rows(), 3);
    for (Eigen::Index k = 0; k < spins.rows(); ++k)
    {
        const Vector3 log = found.measured.logs.row(k).transpose();
        require_whole_log(found.measured.matrices[static_cast<std::size_t>(k)], log);
        found.logs.row(k) = log_rate_of_spin(log, found.spins.row(k).transpose()).transpose();
    }
    return found;
}

}  // namespace sheetmorph::assembly
