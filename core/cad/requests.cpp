// SPDX-License-Identifier: LGPL-2.1-or-later
#include "requests.h"
#include "model_answer.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/reading/cad_reader.h"
#include "sheetmorph/cad/writing/cad_writer.h"
#include "sheetmorph/cad/writing/kept_model.h"

#include <cstring>

namespace sheetmorph::cad_worker
{

namespace
{

using Fields = std::vector<std::string>;

template <typename Number>
std::vector<Number> numbers_in(const std::string& field)
{
    std::vector<Number> numbers(field.size() / sizeof(Number));
    std::memcpy(numbers.data(), field.data(), numbers.size() * sizeof(Number));
    return numbers;
}

cad::CadMeshing meshing_in(const std::string& field)
{
    const auto sizes = numbers_in<double>(field);
    return {sizes.at(0), sizes.at(1), sizes.at(2)};
}

Points positions_in(const std::string& field)
{
    const auto numbers = numbers_in<double>(field);
    return Eigen::Map<const Points>(numbers.data(), static_cast<Eigen::Index>(numbers.size() / 3),
                                    3);
}

cad::CadFormat format_in(const std::string& field)
{
    if (field == "iges")
        return cad::CadFormat::iges;
    if (field == "brep")
        return cad::CadFormat::brep;
    if (field != "step")
        throw InvalidInput("a CAD file is written as step, iges or brep, not " + field);
    return cad::CadFormat::step;
}

std::vector<cad::CadMeasures> written(const cad::CadModel& model, const Fields& request,
                                      const Progress& progress)
{
    const auto tolerances = numbers_in<double>(request.at(3));
    cad::CadWriting wanted;
    wanted.path = request.at(1);
    wanted.format = format_in(request.at(2));
    wanted.tolerance = tolerances.at(0);
    wanted.edge_tolerance = tolerances.at(1);
    std::vector<Points> positions;
    for (std::size_t k = 4; k < request.size(); ++k)
        positions.push_back(positions_in(request[k]));
    return cad::write_cad(model, positions, wanted, progress);
}

std::size_t number_of(const Fields& request)
{
    return static_cast<std::size_t>(numbers_in<int>(request.at(1)).at(0));
}

Answer bytes(const std::string& data)
{
    Answer answer;
    answer.open('{').close('}');
    answer.add_data(data);
    return answer;
}

}  // namespace

Answer Requests::answer(const Fields& request, const Progress& progress)
{
    const std::string& what = request.at(0);
    if (what == "kept_mesh")
        return bytes(cad::kept_mesh(model_.parts.at(number_of(request))));
    if (what == "brep")
        return bytes(cad::brep_of(model_, static_cast<int>(number_of(request))));
    if (what == "write_cad")
        return measures_answer(written(model_, request, progress));
    if (what == "read_cad")
        model_ = cad::read_cad(request.at(1), meshing_in(request.at(2)), progress);
    else if (what == "read_brep")
        model_ = cad::read_brep(request.at(1), request.at(2), meshing_in(request.at(3)), progress);
    else if (what == "kept_model")
        model_ = cad::kept_model(request.at(1), request.at(2), request.at(3));
    else
        throw InvalidInput("the CAD worker knows no request '" + what + "'");
    return model_answer(model_);
}

}  // namespace sheetmorph::cad_worker
