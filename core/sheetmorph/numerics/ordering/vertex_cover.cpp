// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/ordering/vertex_cover.h"

#include "sheetmorph/base/index.h"

#include <limits>
#include <utility>

namespace sheetmorph::numerics
{

namespace
{

constexpr int none = -1;
constexpr int dead = std::numeric_limits<int>::max();  // no augmenting path leads through it

class Matching
{
public:
    explicit Matching(const BipartiteGraph& graph)
        : graph_(graph),
          right_of_(at(graph.left_count()), none),
          left_of_(at(graph.right_count), none),
          reached_(at(graph.right_count), none),
          reached_from_(at(graph.right_count), none)
    {
    }

    VertexCover cover()
    {
        for (int left = 0; left < graph_.left_count(); ++left)
            match_greedily(left);
        VertexCover found{std::vector<char>(right_of_.size(), 1),
                          std::vector<char>(left_of_.size(), 0)};
        for (int left = 0; left < graph_.left_count(); ++left)
            if (right_of_[at(left)] == none && !augment(left))
                for (const int searched : queue_)
                {
                    found.left[at(searched)] = 0;
                    for (int edge = begin(searched); edge < end(searched); ++edge)
                        reached_[at(graph_.right[at(edge)])] = dead;
                }
        for (std::size_t right = 0; right < reached_.size(); ++right)
            found.right[right] = reached_[right] == dead ? 1 : 0;
        return found;
    }

private:
    int begin(int left) const { return graph_.first[at(left)]; }
    int end(int left) const { return graph_.first[at(left) + 1]; }

    void match_greedily(int left)
    {
        for (int edge = begin(left); edge < end(left); ++edge)
            if (const int right = graph_.right[at(edge)]; left_of_[at(right)] == none)
            {
                right_of_[at(left)] = right;
                left_of_[at(right)] = left;
                return;
            }
    }

    //! Searches breadth-first for a path that alternates between edges outside and inside the
    //! matching, and swaps them. Returns false if there is none; the queue then holds the left
    //! vertices that it has reached.
    bool augment(int root)
    {
        queue_.assign(1, root);
        for (std::size_t k = 0; k < queue_.size(); ++k)
        {
            const int left = queue_[k];
            for (int edge = begin(left); edge < end(left); ++edge)
            {
                const int right = graph_.right[at(edge)];
                int& reached = reached_[at(right)];
                if (reached == root || reached == dead)
                    continue;
                reached = root;
                reached_from_[at(right)] = left;
                if (left_of_[at(right)] == none)
                {
                    swap_path(right);
                    return true;
                }
                queue_.push_back(left_of_[at(right)]);
            }
        }
        return false;
    }

    void swap_path(int right)
    {
        while (right != none)
        {
            const int left = reached_from_[at(right)];
            left_of_[at(right)] = left;
            std::swap(right_of_[at(left)], right);
        }
    }

    const BipartiteGraph& graph_;
    std::vector<int> right_of_, left_of_;  // partners
    std::vector<int> reached_;             // by right vertex: root of the last search
    std::vector<int> reached_from_;        // by right vertex
    std::vector<int> queue_;
};

}  // namespace

VertexCover smallest_vertex_cover(const BipartiteGraph& graph)
{
    return Matching(graph).cover();
}

}  // namespace sheetmorph::numerics
