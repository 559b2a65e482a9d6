// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace sheetmorph
{

//! What the caller gave cannot be used; the text names the part, the ids and what to change.
class InvalidInput : public std::invalid_argument
{
public:
    using std::invalid_argument::invalid_argument;

    //! A message around vertex indices: "before 3, 7 and 5 more after".
    InvalidInput(std::string before, std::vector<int> vertices, std::string after);

    //! The same message with the part's name in front and its vertices as its file numbers them.
    //! \param ids  (n) the file's number of every vertex; empty if they are the indices
    InvalidInput in_part(const std::string& part, const std::vector<int>& ids) const;

private:
    std::string before_;
    std::vector<int> vertices_;
    std::string after_;
};

//! The kernel could not finish a computation whose input was accepted.
class SolverError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

//! The progress callback asked to stop.
class Cancelled : public std::runtime_error
{
public:
    Cancelled() : std::runtime_error("cancelled by the user") {}
};

//! "3, 7, 12 and 5 more": the first ids of a list, for messages.
std::string list_ids(const std::vector<int>& ids, std::size_t shown = 8);

}  // namespace sheetmorph
