// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arrays.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/limits.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

namespace py = pybind11;

namespace sheetmorph
{

namespace
{

std::string shape_of(const py::array& array)
{
    std::string text = "(";
    for (py::ssize_t k = 0; k < array.ndim(); ++k)
        text += (k ? ", " : "") + std::to_string(array.shape(k));
    return text + ")";
}

py::array array_from(const py::handle& object, const std::string& what, const std::string& wanted)
{
    if (!py::isinstance<py::array>(object))
        throw py::type_error(what + " must be a numpy array, " + wanted + "; got "
                             + std::string(py::str(py::type::of(object).attr("__name__"))));
    return py::reinterpret_borrow<py::array>(object);
}

[[noreturn]] void refuse_type(const py::array& array, const std::string& what,
                              const std::string& wanted)
{
    throw py::type_error(what + " must be " + wanted + "; got "
                         + std::string(py::str(py::object(array.dtype()))));
}

void require_columns(const py::array& array, const std::string& what)
{
    if (array.ndim() != 2 || array.shape(1) != 3)
        throw py::value_error(what + " must have the shape (n, 3); got " + shape_of(array));
}

void require_numbers(const Points& points, const std::string& what)
{
    std::vector<int> bad;
    for (Eigen::Index row = 0; row < points.rows(); ++row)
        if (!are_numbers(points.row(row)))
            bad.push_back(static_cast<int>(row));
    if (!bad.empty())
        throw InvalidInput(what + " hold coordinates that are not finite numbers, or beyond 1e30 "
                               + "mm: vertices " + list_ids(bad),
                           "repair or remove them");
}

template <typename Integer>
int index_from(Integer value, const std::string& what)
{
    if (value > std::numeric_limits<int>::max() || value < std::numeric_limits<int>::min())
        throw py::value_error(what + " holds " + std::to_string(value)
                              + ", which is too large for an index");
    return static_cast<int>(value);
}

std::int64_t integer_from(const py::handle& object, const std::string& what)
{
    int overflow = 0;
    const py::int_ number(py::reinterpret_borrow<py::object>(object));
    const long long value = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
    if (overflow != 0)
        throw py::value_error(what + " holds a number that is too large for an index");
    return value;
}

template <typename Integer>
void copy_indices(const py::array& array, const std::string& what, int* out)
{
    const auto packed = py::array_t<Integer, py::array::c_style | py::array::forcecast>(array);
    for (py::ssize_t k = 0; k < packed.size(); ++k)
        out[k] = index_from(packed.data()[k], what);
}

void fill_indices(const py::array& array, const std::string& what, int* out)
{
    if (py::isinstance<py::array_t<std::int32_t>>(array))
        copy_indices<std::int32_t>(array, what, out);
    else if (py::isinstance<py::array_t<std::int64_t>>(array))
        copy_indices<std::int64_t>(array, what, out);
    else
        refuse_type(array, what, "int32 or int64");
}

template <typename Matrix>
auto take_over(Matrix&& matrix)
{
    using Plain = std::decay_t<Matrix>;
    using Scalar = typename Plain::Scalar;
    auto held = std::make_unique<Plain>(std::forward<Matrix>(matrix));
    Plain* kept = held.get();
    const py::capsule owner(held.release(), [](void* data) { delete static_cast<Plain*>(data); });
    return py::array_t<Scalar>({kept->rows(), kept->cols()}, kept->data(), owner);
}

}  // namespace

Points points_from(const py::handle& object, const std::string& what)
{
    const py::array array = array_from(object, what, "(n, 3) float64");
    if (!py::isinstance<py::array_t<double>>(array))
        refuse_type(array, what, "float64");
    require_columns(array, what);
    const auto packed = py::array_t<double, py::array::c_style | py::array::forcecast>(array);
    Points points = Eigen::Map<const Points>(packed.data(), packed.shape(0), 3);
    require_numbers(points, what);
    return points;
}

Triangles triangles_from(const py::handle& object, const std::string& what)
{
    const py::array array = array_from(object, what, "(m, 3) int32");
    require_columns(array, what);
    Triangles triangles(array.shape(0), 3);
    fill_indices(array, what, triangles.data());
    return triangles;
}

VertexIds ids_from(const py::handle& object, const std::string& what)
{
    if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object))
    {
        VertexIds ids;
        for (const py::handle& item : py::reinterpret_borrow<py::sequence>(object))
        {
            if (!py::isinstance<py::int_>(item) && !PyIndex_Check(item.ptr()))
                throw py::type_error(what + " must hold integers");
            ids.push_back(index_from(integer_from(item, what), what));
        }
        return ids;
    }
    const py::array array = array_from(object, what, "(k,) int32, or a list of integers");
    if (array.ndim() != 1)
        throw py::value_error(what + " must have the shape (k,); got " + shape_of(array));
    VertexIds ids(static_cast<std::size_t>(array.shape(0)));
    if (!ids.empty())
        fill_indices(array, what, ids.data());
    return ids;
}

Vector3 vector_from(const py::handle& object, const std::string& what)
{
    if (!py::isinstance<py::sequence>(object) && !py::isinstance<py::array>(object))
        throw py::type_error(what + " must be three numbers");
    const auto numbers =
        py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(object);
    if (!numbers)
    {
        PyErr_Clear();
        throw py::type_error(what + " must be three numbers");
    }
    if (numbers.size() != 3)
        throw py::value_error(what + " must be three numbers; got "
                              + std::to_string(numbers.size()));
    const Vector3 vector(numbers.data()[0], numbers.data()[1], numbers.data()[2]);
    if (!are_numbers(vector))
        throw InvalidInput(what + " must be three finite numbers, none beyond 1e30");
    return vector;
}

py::array_t<double> to_numpy(Points&& points)
{
    return take_over(std::move(points));
}

py::array_t<int> to_numpy(Triangles&& triangles)
{
    return take_over(std::move(triangles));
}

py::array_t<int> to_numpy(const VertexIds& ids)
{
    return py::array_t<int>(static_cast<py::ssize_t>(ids.size()), ids.data());
}

py::list to_lists(const std::vector<VertexIds>& loops)
{
    py::list list;
    for (const VertexIds& loop : loops)
        list.append(to_numpy(loop));
    return list;
}

py::array_t<double> to_numpy(const Vector3& vector)
{
    return py::array_t<double>(3, vector.data());
}

py::array_t<double> to_numpy(const Matrix3& matrix)
{
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = matrix;
    return py::array_t<double>({3, 3}, rows.data());
}

py::array_t<double> view_of(const Points& points, const py::handle& owner)
{
    py::array_t<double> view({points.rows(), points.cols()}, points.data(), owner);
    py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return view;
}

}  // namespace sheetmorph
