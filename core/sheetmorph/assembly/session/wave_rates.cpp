// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/wave_rates.h"

#include "sheetmorph/assembly/session/wave.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/surface/rates/pose_rates.h"

namespace sheetmorph::assembly
{

namespace
{

template <typename Value>
Value value_or_none(const std::map<std::string, Value>& values, const std::string& name)
{
    const auto found = values.find(name);
    return found == values.end() ? Value{} : found->second;
}

template <>
Vector3 value_or_none(const std::map<std::string, Vector3>& values, const std::string& name)
{
    const auto found = values.find(name);
    return found == values.end() ? Vector3(Vector3::Zero()) : found->second;
}

//! What parts so far have made of one direction.
struct Passing
{
    PoseRate pose;
    std::vector<volume::LinkedRates> links;
    std::vector<MotionRate> welds;
    std::vector<Points> parts;
};

void require_differentiable(const PreparedAssembly& prepared)
{
    if (prepared.symmetry)
        throw NoDerivative("assemblies with a plane of symmetry are not differentiated");
    if (!prepared.pairs.empty())
        throw NoDerivative("features that keep an axis or a distance are not differentiated");
    for (std::size_t k = 0; k < prepared.parts.size(); ++k)
        if (prepared.parts[k].thin)
            throw NoDerivative("part '" + prepared.assembly.parts[k].name
                               + "' is a thin solid, which is not differentiated");
}

// The pose's numbers are those of handles, their spins follow.
PoseRate with_spins(const Pose& pose, PoseRate rate)
{
    for (auto& [name, motion] : rate.handles)
        motion.spin = spin_of_log(value_or_none(pose.handles, name).rotation_log, motion.log);
    return rate;
}

surface::PropagatedRate propagated_rate(const std::vector<std::vector<LinkRow>>& region,
                                        const std::vector<volume::LinkedTargets>& at_pose,
                                        const std::vector<volume::LinkedRates>& links)
{
    const auto count = static_cast<Eigen::Index>(region.size());
    surface::PropagatedRate rate{Points::Zero(count, 3), Points::Zero(count, 3), Points(count, 3)};
    for (Eigen::Index k = 0; k < count; ++k)
    {
        double weights = 0.0;
        Matrix3 sum = Matrix3::Zero(), change = Matrix3::Zero();
        for (const LinkRow& row : region[at(k)])
        {
            const volume::LinkedRates& link = links[at(row.link)];
            const Matrix3 rotation = at_pose[at(row.link)].rotation(row.row);
            rate.positions.row(k) += row.weight * link.positions.row(row.row);
            rate.rotation_logs.row(k) += row.weight * link.logs.row(row.row);
            sum += row.weight * rotation;
            change += row.weight * cross_matrix(link.spins.row(row.row).transpose()) * rotation;
            weights += row.weight;
        }
        rate.positions.row(k) /= weights;
        rate.rotation_logs.row(k) /= weights;
        rate.spins.row(k) = spin_of_polar(polar_rotation(sum), sum, change).transpose();
    }
    return rate;
}

//! One pose in several directions.
class WaveRates
{
public:
    WaveRates(const PreparedAssembly& prepared, const Pose& pose,
              const std::vector<PoseRate>& directions)
        : prepared_(prepared), wave_(prepared, pose, Exactness::exact), result_(wave_.run())
    {
        for (const PoseRate& rate : directions)
        {
            passing_.push_back({with_spins(pose, rate), {}, {}, {}});
            passing_.back().links.resize(prepared.links.size());
            passing_.back().welds.resize(prepared.welds.size());
            for (const Part& part : prepared.assembly.parts)
                passing_.back().parts.push_back(Points::Zero(part.mesh.vertex_count(), 3));
        }
    }

    std::vector<std::vector<Points>> run()
    {
        for (const int part : prepared_.plan.order)
            pass(part);
        std::vector<std::vector<Points>> found;
        for (Passing& passing : passing_)
            found.push_back(std::move(passing.parts));
        return found;
    }

private:
    void pass(int index)
    {
        const PreparedPart& part = prepared_.parts[at(index)];
        const std::unique_ptr<surface::PoseRates> rates =
            part.deformer ? part.deformer->rates(wave_.targets_of(index)) : nullptr;
        for (Passing& passing : passing_)
        {
            surface::DeformationRate rate;
            if (rates)
                rate = rates->along(targets_of(part.problem, passing));
            else
            {
                const Eigen::Index count = passing.parts[at(index)].rows();
                rate = {Points::Zero(count, 3), Points::Zero(count, 3), {}};
                rate.features.resize(part.problem.own.surface.features.size());
            }
            pass_on(index, rate, passing);
        }
    }

    void pass_on(int index, surface::DeformationRate& rate, Passing& passing) const
    {
        const PartProblem& problem = prepared_.parts[at(index)].problem;
        for (std::size_t k = 0; k < prepared_.links.size(); ++k)
            if (prepared_.planned[k].source_part == index)
                passing.links[k] =
                    prepared_.links[k].link->transfer_rate(result_.parts[at(index)], rate);
        for (std::size_t k = 0; k < problem.carriers.size(); ++k)
            passing.welds[at(problem.carriers[k])] = rate.features[problem.own.features.size() + k];
        passing.parts[at(index)] = std::move(rate.positions);
    }

    // targets_in_order(), of how they change.
    surface::TargetRates targets_of(const PartProblem& problem, const Passing& passing) const
    {
        const Assembly& assembly = prepared_.assembly;
        surface::TargetRates rates;
        for (const int handle : problem.own.handles)
            rates.handles.push_back(
                value_or_none(passing.pose.handles, assembly.handles[at(handle)].name));
        for (const int weld : problem.carried)
            rates.handles.push_back(passing.welds[at(weld)]);
        for (const int feature : problem.own.features)
        {
            const std::string& name = assembly.features[at(feature)].name;
            rates.feature_logs.push_back(value_or_none(passing.pose.feature_logs, name));
            rates.sizes.push_back(value_or_none(passing.pose.sizes, name));
        }
        rates.feature_logs.resize(problem.own.surface.features.size(), Vector3::Zero());
        rates.sizes.resize(problem.own.surface.features.size(), 0.0);
        for (const int point : problem.own.points)
            rates.points.push_back(
                value_or_none(passing.pose.points, assembly.points[at(point)].name));
        for (const auto& region : problem.propagated)
            rates.propagated.push_back(propagated_rate(region, wave_.links(), passing.links));
        return rates;
    }

    const PreparedAssembly& prepared_;
    Wave wave_;
    Deformed result_;
    std::vector<Passing> passing_;
};

// What was solved at once, by direction and part.
std::vector<std::vector<Points>> split(const PreparedAssembly& prepared,
                                       const std::vector<std::vector<Points>>& joined)
{
    std::vector<std::vector<Points>> found;
    for (const std::vector<Points>& along : joined)
    {
        found.emplace_back();
        for (std::size_t part = 0; part < prepared.parts.size(); ++part)
        {
            const int count = prepared.assembly.parts[part].mesh.vertex_count();
            const int first = prepared.places.first[part];
            found.back().push_back(first < 0 ? Points(Points::Zero(count, 3))
                                             : Points(along.front().middleRows(first, count)));
        }
    }
    return found;
}

}  // namespace

std::vector<std::vector<Points>> wave_rates(const PreparedAssembly& prepared, const Pose& pose,
                                            const std::vector<PoseRate>& directions)
{
    require_differentiable(prepared);
    if (prepared.joined)
        return split(prepared, wave_rates(*prepared.joined, pose, directions));
    return WaveRates(prepared, pose, directions).run();
}

}  // namespace sheetmorph::assembly
