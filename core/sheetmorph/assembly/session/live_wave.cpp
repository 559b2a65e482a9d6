// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/wave.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"

#include <algorithm>

namespace sheetmorph::assembly
{

namespace
{

// Sheets are placed at the same time if they have this many vertices together. Chosen, not
// measured: estimated at 20 ns a vertex, 200 microseconds, several times as long as waking a
// thread.
constexpr int many_vertices = 10000;

}  // namespace

std::vector<char> Wave::run_live(const Responses& responses,
                                 std::vector<surface::Deformation>& read, Deformed& result)
{
    start(result);
    begin_reading(read);
    std::vector<char> answered(system_.sheets.size(), 0);
    for (const std::vector<int>& stage : system_.stages)
        run_stage(stage, responses, answered);
    set_others_at_rest();
    place_answers();
    std::vector<char> parts;
    for (int part = 0; part < static_cast<int>(result.parts.size()); ++part)
    {
        parts.push_back(answered[at(system_.sheet_of(part))]);
        if (parts.back())
            result.parts[at(part)].convergence = {};
        mark_preview(part);
        report_features(part);
    }
    return parts;
}

// All its sheets at the same time, then all that they pass on.
void Wave::run_stage(const std::vector<int>& sheets, const Responses& responses,
                     std::vector<char>& answered)
{
    parallel_items(static_cast<Eigen::Index>(sheets.size()),
                   [&](Eigen::Index k)
                   {
                       const int index = sheets[at(k)];
                       answered[at(index)] = answer(index, responses[at(index)]);
                   });
    std::vector<std::size_t> links;
    for (std::size_t k = 0; k < links_.size(); ++k)
        if (std::count(sheets.begin(), sheets.end(), system_.sheet_of(system_.links[k].source_part))
            > 0)
            links.push_back(k);
    parallel_items(static_cast<Eigen::Index>(links.size()),
                   [&](Eigen::Index k) { pass_on_link(links[at(k)]); });
    for (const int index : sheets)
        pass_on_motions(index);
}

void Wave::begin_reading(std::vector<surface::Deformation>& read)
{
    read.resize(system_.sheets.size());
    read_ = &read;
    is_in_read_.assign(system_.sheets.size(), 0);
}

bool Wave::read(int index, const surface::Response& response)
{
    const std::optional<surface::Response::Frame> frame = response.frame(targets_of(index));
    if (!frame)
        return false;
    is_in_read_[at(index)] = 1;
    response.place_reads(*frame, (*read_)[at(index)]);
    pass_on(index);
    return true;
}

// What later sheets read at once, everything when all sheets are; a thin solid hangs on the whole
// of its middle, parts that share a sheet on the whole of that, and later sheets read sizes too.
bool Wave::respond(int index, const std::shared_ptr<const surface::Response>& response)
{
    const ThinSolver* thin = thin_of(index);
    if (thin != nullptr && thin->has_points())
        return false;
    const surface::SurfaceTargets targets = targets_of(index);
    auto frame =
        std::make_shared<std::optional<surface::Response::Frame>>(response->frame(targets));
    if (!*frame)
        return false;
    if (thin != nullptr || is_shared(index) || (*frame)->has_sizes())
    {
        response->place(**frame, solved(index));
        hand_out(index, targets);
        return true;
    }
    is_in_read_[at(index)] = 1;
    response->place_reads(**frame, (*read_)[at(index)]);
    answers_[at(index)] = [response, frame](surface::Deformation& shape)
    { response->place(**frame, shape); };
    return true;
}

void Wave::place_answers() const
{
    int vertices = 0;
    std::vector<int> placed;
    for (std::size_t index = 0; index < answers_.size(); ++index)
        if (answers_[index])
        {
            vertices += system_.sheets[index].mesh.vertex_count();
            placed.push_back(static_cast<int>(index));
        }
    const auto place = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index k = begin; k < end; ++k)
            answers_[at(placed[at(k)])](solved(placed[at(k)]));
    };
    const auto count = static_cast<Eigen::Index>(placed.size());
    parallel_ranges(count, vertices < many_vertices ? count : 1, place);
}

}  // namespace sheetmorph::assembly
