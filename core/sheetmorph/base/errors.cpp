// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/errors.h"

namespace sheetmorph
{

namespace
{

Fault on_parts(Fault fault, const std::string& shown, const std::vector<Subject>& on,
               const std::vector<int>& ids)
{
    fault.part = shown;
    fault.on = on;
    fault.ids = ids;
    return fault;
}

}  // namespace

std::string Fault::sentence() const
{
    const std::string place = part.empty() ? "" : "part '" + part + "': ";
    return place + what.full(ids) + (todo.empty() ? "" : "; " + todo);
}

InvalidInput::InvalidInput(Text what, std::string todo, FaultCode code)
    : InvalidInput(Fault{std::move(what), std::move(todo), code})
{
}

InvalidInput::InvalidInput(Fault fault)
    : std::invalid_argument(fault.sentence()), fault_(std::move(fault))
{
}

InvalidInput InvalidInput::in_part(const std::string& part, const std::vector<int>& ids) const
{
    return in_parts(part, {{"part", part}}, ids);
}

InvalidInput InvalidInput::in_parts(const std::string& shown, const std::vector<Subject>& on,
                                    const std::vector<int>& ids) const
{
    return InvalidInput(on_parts(fault_, shown, on, ids));
}

SolverError::SolverError(Text what, std::string todo)
    : SolverError(Fault{std::move(what), std::move(todo)})
{
}

SolverError::SolverError(Fault fault)
    : std::runtime_error(fault.sentence()), fault_(std::move(fault))
{
}

SolverError SolverError::in_parts(const std::string& shown, const std::vector<Subject>& on) const
{
    return SolverError(on_parts(fault_, shown, on, {}));
}

}  // namespace sheetmorph
