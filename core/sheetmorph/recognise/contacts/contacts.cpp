// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/contacts/contacts.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/recognise/contacts/contact_patches.h"
#include "sheetmorph/recognise/contacts/found_contacts.h"
#include "sheetmorph/recognise/contacts/part_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

namespace sheetmorph::recognise
{

namespace
{

constexpr double weld = FeatureTolerances{}.weld;  // from the search for features

// Largest gap that is ever proposed, relative to the size of the assembly. Measured: half of it
// misses the gap of Contacts.TheGapIsProposedFromTheAssembly. Chosen: sheets farther apart are not
// joined.
constexpr double widest_gap = 0.012;

// Smallest gap that is ever proposed, relative to the size. Measured: twice as much joins parts
// that do not touch (Contacts.LargePartsThatDoNotTouchAreNotProposed).
constexpr double closest_gap = 1e-3;

// mm. Joined sheets are at most this far apart, however large the assembly is. Chosen: two thick
// sheets and the bead between them.
constexpr double farthest_joined = 10.0;

// Relative to the size of the assembly. Longer elements carry masses or loads and do not join
// parts. Measured: half of it loses the welds of Contacts.ElementsBetweenPartsAreWelds.
constexpr double farthest_connection = 0.06;

// Of gap_before_quiet(). Chosen: a gap is the right one if it covers a fair share of the near area
// and a gap half as wide again adds hardly any. Flanges that diverge from a joint add much more.
constexpr double quiet = 1.5;
constexpr double fair_share = 0.2;
constexpr double hardly_any = 0.03;

// Ratio of the proposed gap to the gap found. Chosen below `quiet`, so that nothing is added.
// Measured: 0.6 misses the gap of Contacts.TheGapIsProposedFromTheAssembly; 2.4 joins the parts of
// Contacts.LargePartsThatDoNotTouchAreNotProposed.
constexpr double above = 1.2;

std::vector<PartShape> shapes_of(const std::vector<ContactPart>& parts, const Progress& progress)
{
    std::vector<PartShape> shapes;
    shapes.reserve(parts.size());
    for (const ContactPart& part : parts)
    {
        progress.report(static_cast<double>(shapes.size()) / static_cast<double>(parts.size()),
                        "preparing the parts");
        shapes.emplace_back(part, weld);
    }
    return shapes;
}

double size_of(const std::vector<PartShape>& shapes)
{
    if (shapes.empty())
        return 0.0;
    Vector3 low = shapes.front().low();
    Vector3 high = shapes.front().high();
    for (const PartShape& shape : shapes)
    {
        low = low.cwiseMin(shape.low());
        high = high.cwiseMax(shape.high());
    }
    return (high - low).norm();
}

// A pair of near surfaces: the gap beyond their half thicknesses in mm, the area it represents in
// mm^2.
using Gap = std::pair<double, double>;

// The gaps of facing surfaces, and of free edges on a surface up to `closest`; ascending.
std::vector<Gap> gaps_between(const std::vector<PartShape>& shapes, double widest, double closest,
                              double facing_angle)
{
    std::vector<Gap> gaps;
    for (const auto& [a, b] : near_pairs(shapes, widest))
        for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)})
        {
            const double between = 0.5 * (shapes[one].thickness() + shapes[other].thickness());
            for (const Touch& touch :
                 shapes[one].touches(shapes[other], widest + between, facing_angle))
            {
                const double gap = std::max(0.0, touch.distance - between);
                if (!touch.is_edge || gap <= closest)
                    gaps.emplace_back(gap, shapes[one].area_at(touch.vertex));
            }
        }
    std::sort(gaps.begin(), gaps.end());
    return gaps;
}

// The smallest gap from `closest` on that covers `fair_share` of the area, if the gaps up to
// `quiet` times that gap add at most the share `hardly_any`. Returns `closest` if no gap qualifies.
double gap_before_quiet(const std::vector<Gap>& gaps, double closest)
{
    double all = 0.0;
    for (const Gap& gap : gaps)
        all += gap.second;
    std::size_t next = 0;
    std::size_t ahead = 0;
    double within = 0.0;
    double up_to_ahead = 0.0;
    for (double gap = closest; next <= gaps.size();)
    {
        for (; next < gaps.size() && gaps[next].first <= gap; ++next)
            within += gaps[next].second;
        for (; ahead < gaps.size() && gaps[ahead].first <= quiet * gap; ++ahead)
            up_to_ahead += gaps[ahead].second;
        if (within >= fair_share * all && up_to_ahead - within <= hardly_any * within)
            return gap;
        if (next == gaps.size())
            break;
        gap = gaps[next].first;
    }
    return closest;
}

double proposed_gap_of(const std::vector<PartShape>& shapes, const ContactTolerances& tolerances)
{
    const double size = size_of(shapes);
    const double widest = std::min(widest_gap * size, farthest_joined);
    const double closest = std::min(closest_gap * size, widest);
    const auto gaps = gaps_between(shapes, widest, closest, tolerances.facing_angle);
    return above * gap_before_quiet(gaps, closest);
}

}  // namespace

const char* name_of(ContactKind kind)
{
    static constexpr std::array<const char*, 5> names = {"bolt", "weld", "flange", "face", "edge"};
    return names[static_cast<std::size_t>(kind)];
}

const char* type_of(const FoundContact& contact)
{
    if (contact.kind == ContactKind::bolt || contact.is_spot)
        return "rigid";
    const bool is_tied = contact.kind == ContactKind::flange || contact.kind == ContactKind::weld;
    return is_tied ? "tied" : "control mesh";
}

double proposed_gap(const std::vector<ContactPart>& parts, const ContactTolerances& tolerances)
{
    tolerances.check();
    return proposed_gap_of(shapes_of(parts, {}), tolerances);
}

std::vector<FoundContact> find_contacts(const std::vector<ContactPart>& parts,
                                        const std::vector<Connection>& connections,
                                        const ContactTolerances& tolerances,
                                        const Progress& progress)
{
    tolerances.check();
    const std::vector<PartShape> shapes = shapes_of(parts, progress.part(0.0, 0.3));
    ContactTolerances used = tolerances;
    if (used.gap < 0.0)
        used.gap = proposed_gap_of(shapes, tolerances);
    ContactCollector collector(parts, shapes, used);
    collector.take_connections(connections, farthest_connection * size_of(shapes));
    collector.take_bolts(find_bolts(parts, used.gap, used));
    const auto pairs = near_pairs(shapes, used.gap);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        progress.report(0.3 + 0.7 * static_cast<double>(i) / static_cast<double>(pairs.size()),
                        "comparing neighbours");
        collector.take_pair(pairs[i].first, pairs[i].second);
    }
    return collector.found();
}

}  // namespace sheetmorph::recognise
