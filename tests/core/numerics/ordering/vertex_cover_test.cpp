// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/ordering/vertex_cover.h"

#include <algorithm>
#include <bitset>
#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::numerics
{
namespace
{

BipartiteGraph random_graph(int left, int right, double share, std::mt19937& random)
{
    std::bernoulli_distribution is_edge(share);
    BipartiteGraph graph;
    graph.right_count = right;
    for (int a = 0; a < left; ++a)
    {
        for (int b = 0; b < right; ++b)
            if (is_edge(random))
                graph.right.push_back(b);
        graph.first.push_back(static_cast<int>(graph.right.size()));
    }
    return graph;
}

// use(left, right) for all edges.
template <typename Use>
void for_edges(const BipartiteGraph& graph, const Use& use)
{
    for (int left = 0; left < graph.left_count(); ++left)
        for (int edge = graph.first[static_cast<std::size_t>(left)];
             edge < graph.first[static_cast<std::size_t>(left) + 1]; ++edge)
            use(static_cast<std::size_t>(left),
                static_cast<std::size_t>(graph.right[static_cast<std::size_t>(edge)]));
}

int size_of(const VertexCover& cover)
{
    return static_cast<int>(std::count(cover.left.begin(), cover.left.end(), 1)
                            + std::count(cover.right.begin(), cover.right.end(), 1));
}

// The right vertices that a choice of left ones leaves to be covered are given by the edges.
int fewest_by_trying_all(const BipartiteGraph& graph)
{
    int fewest = graph.left_count() + graph.right_count;
    for (unsigned long chosen = 0; chosen < 1UL << graph.left_count(); ++chosen)
    {
        std::bitset<16> left(chosen), right;
        for_edges(graph,
                  [&](std::size_t a, std::size_t b)
                  {
                      if (!left[a])
                          right.set(b);
                  });
        fewest = std::min(fewest, static_cast<int>(left.count() + right.count()));
    }
    return fewest;
}

TEST(VertexCover, TouchesAllEdgesWithTheFewestVertices)
{
    std::mt19937 random(3);
    for (int trial = 0; trial < 300; ++trial)
    {
        const BipartiteGraph graph =
            random_graph(static_cast<int>(random() % 10), static_cast<int>(random() % 16),
                         0.02 * static_cast<double>(random() % 30), random);
        const VertexCover cover = smallest_vertex_cover(graph);
        ASSERT_EQ(cover.left.size(), static_cast<std::size_t>(graph.left_count()));
        ASSERT_EQ(cover.right.size(), static_cast<std::size_t>(graph.right_count));
        for_edges(graph, [&](std::size_t a, std::size_t b)
                  { ASSERT_TRUE(cover.left[a] != 0 || cover.right[b] != 0); });
        ASSERT_EQ(size_of(cover), fewest_by_trying_all(graph)) << "trial " << trial;
    }
}

TEST(VertexCover, ChoosesTheMiddleOfStars)
{
    std::mt19937 random(1);
    EXPECT_EQ(size_of(smallest_vertex_cover(random_graph(1, 1000, 1.0, random))), 1);
    EXPECT_EQ(size_of(smallest_vertex_cover(random_graph(1000, 1, 1.0, random))), 1);
}

}  // namespace
}  // namespace sheetmorph::numerics
