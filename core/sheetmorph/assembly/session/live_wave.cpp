// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/wave.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"

#include <algorithm>

namespace sheetmorph::assembly
{

namespace
{

// Parts are placed at the same time if they have this many vertices together. Chosen, not measured:
// estimated at 20 ns a vertex, 200 microseconds, several times as long as waking a thread.
constexpr int many_vertices = 10000;

}  // namespace

std::vector<char> Wave::run_live(const PartResponses& responses,
                                 std::vector<surface::Deformation>& read, Deformed& result)
{
    start(result);
    if (!prepared_.joined)
        begin_reading(read);
    std::vector<char> answered(result.parts.size(), 0);
    if (prepared_.joined)
    {
        Deformed joined;
        const std::vector<char> all =
            Wave(*prepared_.joined, pose_, exactness_).run_live(responses, read, joined);
        take(joined);
        for (const int part : prepared_.plan.order)
            answered[at(part)] = all.front();
    }
    else
        for (const std::vector<int>& stage : prepared_.stages)
            run_stage(stage, responses, answered);
    for (const int part : prepared_.plan.unreached)
        set_at_rest(part);
    place_answers();
    for (int part = 0; part < static_cast<int>(result.parts.size()); ++part)
    {
        if (answered[at(part)])
            result.parts[at(part)].convergence = {};
        mark_preview(part);
        report_features(part);
    }
    return answered;
}

// All its parts at the same time, then all that they pass on.
void Wave::run_stage(const std::vector<int>& parts, const PartResponses& responses,
                     std::vector<char>& answered)
{
    parallel_items(static_cast<Eigen::Index>(parts.size()),
                   [&](Eigen::Index k)
                   {
                       const int part = parts[at(k)];
                       answered[at(part)] = answer(part, responses[at(part)]);
                   });
    std::vector<std::size_t> links;
    for (std::size_t k = 0; k < links_.size(); ++k)
        if (std::count(parts.begin(), parts.end(), prepared_.planned[k].source_part) > 0)
            links.push_back(k);
    parallel_items(static_cast<Eigen::Index>(links.size()),
                   [&](Eigen::Index k) { pass_on_link(links[at(k)]); });
    for (const int part : parts)
        pass_on_motions(part);
}

void Wave::begin_reading(std::vector<surface::Deformation>& read)
{
    read.resize(prepared_.parts.size());
    read_ = &read;
    is_in_read_.assign(prepared_.parts.size(), 0);
}

bool Wave::read(int part, const surface::Response& response)
{
    const std::optional<surface::Response::Frame> frame = response.frame(targets_of(part));
    if (!frame)
        return false;
    is_in_read_[at(part)] = 1;
    response.place_reads(*frame, (*read_)[at(part)]);
    pass_on(part);
    return true;
}

// What later parts read at once, everything when all parts are; a thin solid hangs on the whole of
// its middle, and later parts read sizes too.
bool Wave::respond(int part, const std::shared_ptr<const surface::Response>& response)
{
    const auto& thin = prepared_.parts[at(part)].thin;
    if (thin && thin->has_points())
        return false;
    const surface::SurfaceTargets targets = targets_of(part);
    auto frame =
        std::make_shared<std::optional<surface::Response::Frame>>(response->frame(targets));
    if (!*frame)
        return false;
    if (thin || (*frame)->has_sizes())
    {
        response->place(**frame, solved(part));
        expand(part, targets);
        return true;
    }
    is_in_read_[at(part)] = 1;
    response->place_reads(**frame, (*read_)[at(part)]);
    answers_[at(part)] = [response, frame](surface::Deformation& shape)
    { response->place(**frame, shape); };
    return true;
}

void Wave::place_answers() const
{
    int vertices = 0;
    std::vector<std::size_t> parts;
    for (std::size_t part = 0; part < answers_.size(); ++part)
        if (answers_[part])
        {
            vertices += prepared_.assembly.parts[part].mesh.vertex_count();
            parts.push_back(part);
        }
    const auto place = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index k = begin; k < end; ++k)
            answers_[parts[at(k)]](result_->parts[parts[at(k)]]);
    };
    const auto count = static_cast<Eigen::Index>(parts.size());
    parallel_ranges(count, vertices < many_vertices ? count : 1, place);
}

}  // namespace sheetmorph::assembly
