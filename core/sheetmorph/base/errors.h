// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/text.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace sheetmorph
{

//! Faults that a caller can correct in its own way; all others are `other`.
enum class FaultCode
{
    other,
    unheld,   //!< a piece of a part has no constraint
    overlap,  //!< two regions share vertices and move them differently
    torn      //!< a rigid shape touches regions that move differently
};

//! What is wrong, which entries of the assembly are affected, and what to do.
struct Fault
{
    Text what;
    std::string todo = {};  //!< empty if the message includes it
    FaultCode code = FaultCode::other;
    std::string part = {};         //!< name of the part, put first
    std::vector<Subject> on = {};  //!< the part, or the parts that are solved together
    std::vector<int> ids = {};     //!< (n) the file's number of every vertex; empty: the indices

    //! "part 'cover': what is wrong; what to do".
    std::string sentence() const;
};

//! The input cannot be used. The text names the part, the ids and the remedy.
class InvalidInput : public std::invalid_argument
{
public:
    InvalidInput(Text what, std::string todo = {}, FaultCode code = FaultCode::other);
    explicit InvalidInput(Fault fault);

    const Fault& fault() const { return fault_; }

    //! Adds the part's name in front, and shows vertices with the numbers of the file.
    //! \param ids  (n) the file's number of every vertex; empty if they are the indices
    InvalidInput in_part(const std::string& part, const std::vector<int>& ids) const;

    //! The same for parts that are solved together. `on` lists the affected ones.
    InvalidInput in_parts(const std::string& shown, const std::vector<Subject>& on,
                          const std::vector<int>& ids) const;

private:
    Fault fault_;
};

//! The kernel could not finish a computation although its input was valid.
class SolverError : public std::runtime_error
{
public:
    SolverError(Text what, std::string todo = {});
    explicit SolverError(Fault fault);

    const Fault& fault() const { return fault_; }

    //! Adds the name in front.
    SolverError in_parts(const std::string& shown, const std::vector<Subject>& on) const;

private:
    Fault fault_;
};

//! The progress callback cancelled the computation.
class Cancelled : public std::runtime_error
{
public:
    Cancelled() : std::runtime_error("cancelled by the user") {}
};

}  // namespace sheetmorph
