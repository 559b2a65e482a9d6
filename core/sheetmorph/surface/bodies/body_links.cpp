// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/bodies/bodies.h"

#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

constexpr int elsewhere = -1;  // the leader is in another part

// Priority of leading: driven bodies lead. Bodies carried by contacts follow only driven bodies.
int rank(const Body& body)
{
    if (body.motion == Body::Motion::propagated)
        return 1;
    return body.is_known() ? 2 : 0;
}

bool can_follow(const Body& body)
{
    const bool is_open_to_turns =
        body.motion == Body::Motion::free || (rank(body) == 1 && body.driver < 0);
    return is_open_to_turns && body.restricted < 0 && body.handle < 0 && !body.following;
}

int body_of(const std::vector<Body>& bodies, int feature)
{
    for (std::size_t k = 0; k < bodies.size(); ++k)
        for (const int own : bodies[k].features)
            if (own == feature)
                return static_cast<int>(k);
    return elsewhere;
}

bool is_coaxial(const SurfaceConstraints& constraints, int link)
{
    return constraints.links[at(link)].type == FeatureLinkType::coaxial;
}

Text named(const SurfaceConstraints& constraints, const FeatureLink& link)
{
    const std::string what =
        link.type == FeatureLinkType::coaxial ? "the coaxial pair '" : "the distance '";
    return Text::about(what + link.name + "'", link.of) + " of feature '"
           + constraints.features[at(link.follower)].name + "'";
}

//! Determines leader and follower, link by link.
class Linking
{
public:
    Linking(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints,
            std::vector<Body>& bodies)
        : mesh_(mesh),
          constraints_(constraints),
          bodies_(bodies),
          trees_(static_cast<int>(bodies.size()))
    {
    }

    void decide(int index)
    {
        const FeatureLink& link = constraints_.links[at(index)];
        Following following{index, link.follower, elsewhere, link.centre};
        int follower = body_of(bodies_, link.follower);
        if (link.leader >= 0)
        {
            following.leader = body_of(bodies_, link.leader);
            if (link.type == FeatureLinkType::distance)
                following.centre = centre_of_feature(link.leader);
            if (following.leader == follower || is_said_already(following, follower))
                return;
            choose_follower(following, follower);
            trees_.join(following.leader, follower);
        }
        if (!can_follow(bodies_[at(follower)]))
            throw InvalidInput(
                named(constraints_, link)
                + " cannot be kept: fixed regions, handles, motions or other pairs already "
                  "constrain both sides, or their rotation is not free",
                "remove one of these, or the pair");
        bodies_[at(follower)].following = following;
        bind_tree(follower);
    }

private:
    Vector3 centre_of_feature(int feature) const
    {
        return centre_of(mesh_, constraints_.features[at(feature)].vertices);
    }

    // A link that closes a loop is redundant if all links of its tree are coaxial. Any other is
    // refused.
    bool is_said_already(const Following& following, int follower)
    {
        const int root = trees_.root(follower);
        if (trees_.root(following.leader) != root)
            return false;
        bool is_coaxial_tree = is_coaxial(constraints_, following.link);
        for (std::size_t k = 0; k < bodies_.size(); ++k)
            if (bodies_[k].following && trees_.root(static_cast<int>(k)) == root)
                is_coaxial_tree &= is_coaxial(constraints_, bodies_[k].following->link);
        if (!is_coaxial_tree)
            throw InvalidInput(named(constraints_, constraints_.links[at(following.link)])
                                   + " closes a loop of pairs",
                               "remove one of them");
        return true;
    }

    void choose_follower(Following& following, int& follower) const
    {
        const Body& leader = bodies_[at(following.leader)];
        const Body& wanted = bodies_[at(follower)];
        if (can_follow(wanted) && rank(wanted) <= rank(leader))
            return;
        const FeatureLink& link = constraints_.links[at(following.link)];
        following.feature = link.leader;
        if (link.type == FeatureLinkType::distance)
            following.centre = centre_of_feature(link.follower);
        std::swap(following.leader, follower);
    }

    // A leader with an unknown translation moves with its followers, so the reduced problem
    // contains both.
    void bind_tree(int body)
    {
        while (body != elsewhere)
        {
            Body& bound = bodies_[at(body)];
            bound.is_bound = !bound.is_known();
            body = bound.following ? bound.following->leader : elsewhere;
        }
    }

    const mesh::TriangleMesh& mesh_;
    const SurfaceConstraints& constraints_;
    std::vector<Body>& bodies_;
    DisjointSets trees_;
};

}  // namespace

std::vector<int> leaders_first(const std::vector<Body>& bodies)
{
    std::vector<int> order;
    std::vector<char> is_listed(bodies.size(), 0);
    while (order.size() < bodies.size())
        for (std::size_t k = 0; k < bodies.size(); ++k)
        {
            const int leader = bodies[k].following ? bodies[k].following->leader : -1;
            if (is_listed[k] || (leader >= 0 && !is_listed[at(leader)]))
                continue;
            is_listed[k] = 1;
            order.push_back(static_cast<int>(k));
        }
    return order;
}

void decide_links(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints,
                  std::vector<Body>& bodies)
{
    Linking linking(mesh, constraints, bodies);
    for (std::size_t k = 0; k < constraints.links.size(); ++k)
        linking.decide(static_cast<int>(k));
}

}  // namespace sheetmorph::surface
