// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/text.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace sheetmorph
{

//! Faults that a caller can mend in a way of its own; all others are `other`.
enum class FaultCode
{
    other,
    unheld,   //!< nothing holds a piece of a part
    overlap,  //!< two regions share vertices and move them differently
    torn      //!< a rigid shape touches regions that move differently
};

//! What is wrong, with which entries of the assembly, and what to do about it.
struct Fault
{
    Text what;
    std::string todo = {};  //!< empty if the message says it
    FaultCode code = FaultCode::other;
    std::string part = {};         //!< shown in front: the part that it is about
    std::vector<Subject> on = {};  //!< that part, or several that are solved as one
    std::vector<int> ids = {};     //!< (n) the file's number of every vertex; empty: the indices

    //! "part 'cover': what is wrong; what to do".
    std::string sentence() const;
};

//! What the caller gave cannot be used; the text names the part, the ids and what to change.
class InvalidInput : public std::invalid_argument
{
public:
    InvalidInput(Text what, std::string todo = {}, FaultCode code = FaultCode::other);
    explicit InvalidInput(Fault fault);

    const Fault& fault() const { return fault_; }

    //! The same with the part's name in front and its vertices as its file numbers them.
    //! \param ids  (n) the file's number of every vertex; empty if they are the indices
    InvalidInput in_part(const std::string& part, const std::vector<int>& ids) const;

    //! The same of a part that was joined of several: `on` are those that it is about.
    InvalidInput in_parts(const std::string& shown, const std::vector<Subject>& on,
                          const std::vector<int>& ids) const;

private:
    Fault fault_;
};

//! The kernel could not finish a computation whose input was accepted.
class SolverError : public std::runtime_error
{
public:
    SolverError(Text what, std::string todo = {});
    explicit SolverError(Fault fault);

    const Fault& fault() const { return fault_; }

    //! The same with the part's name in front.
    SolverError in_parts(const std::string& shown, const std::vector<Subject>& on) const;

private:
    Fault fault_;
};

//! The progress callback asked to stop.
class Cancelled : public std::runtime_error
{
public:
    Cancelled() : std::runtime_error("cancelled by the user") {}
};

}  // namespace sheetmorph
