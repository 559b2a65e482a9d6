// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <Eigen/Dense>
#include <array>

namespace sheetmorph::surface
{

//! A triangle of a thin shell (mathematics.md, section 9). Its membrane strain e is constant, with
//! the energy of St. Venant and Kirchhoff plus a term that grows without bound as the area
//! vanishes. Its curvature is that of Morley's triangle: constant, from the angle by which the
//! director of each side rotated about that side relative to the triangle. Side k runs from corner
//! k to the next.
class ShellElement
{
public:
    using Corners = std::array<Vector3, 3>;

    //! Three corners, then the angles of three directors about their sides.
    using Vector = Eigen::Matrix<double, 12, 1>;
    using Matrix = Eigen::Matrix<double, 12, 12>;

    //! Position of the triangle, and the unit directors of its sides, each at right angles to its
    //! side.
    struct Place
    {
        Corners corners;
        Corners directors;
    };

    //! 2nd Piola-Kirchhoff stress (11, 22, 12) and moments of the sides.
    struct Stress
    {
        Vector3 membrane = Vector3::Zero();
        Vector3 moments = Vector3::Zero();
    };

    //! \param poisson  Poisson's ratio
    ShellElement(const Place& rest, double poisson);

    //! mm^2 at rest.
    double area() const { return area_; }

    //! Membrane strain and bending angles in one position, with the data for derivatives.
    struct Strain
    {
        Vector3 membrane;               //!< e11, e22, 2 e12
        Vector3 angles;                 //!< alpha, radians
        Eigen::Matrix<double, 3, 2> f;  //!< deformation gradient
        Corners gradients;              //!< of the shape functions in the current position, 1/mm
        Corners sides;                  //!< unit
        Eigen::Vector3d lengths;        //!< of the sides, mm
        Vector3 normal;                 //!< unit
    };
    Strain strain(const Place& place) const;

    //! Energy divided by E h, for a bending factor h^2 / 12; mm^2.
    double energy(const Strain& strain, double bending) const;
    Stress stress(const Strain& strain, double bending) const;

    //! The stress after a displacement `step`, to first order.
    Stress predicted(const Strain& strain, double bending, const Vector& step) const;

    Vector gradient(const Strain& strain, double bending) const;

    //! Tangent with the given stress in its second-order part.
    Matrix stiffness(const Strain& strain, double bending, const Stress& of_second_order) const;

    //! The tensile part of a stress, without moments; its tangent is positive semidefinite.
    static Stress tension(const Stress& stress);

private:
    using Rows = Eigen::Matrix<double, 3, 12>;

    //! The resistance to a loss of area, divided by the rest area: energy, stress and tangent with
    //! respect to the membrane strain.
    struct Crushing
    {
        double energy = 0.0;
        Vector3 stress = Vector3::Zero();
        Matrix3 tangent = Matrix3::Zero();
    };
    static Crushing crushing(const Vector3& membrane);
    Vector3 membrane_stress(const Strain& strain) const;
    Matrix3 membrane_tangent(const Strain& strain) const;
    Rows membrane_rows(const Strain& strain) const;
    static Rows angle_rows(const Strain& strain);
    static void add_turning(const Strain& strain, int side, double moment, Matrix& sum);

    Eigen::Matrix<double, 3, 2> gradients_;  // of the shape functions at rest, in its plane
    double area_;
    Matrix3 elasticity_;   // times area
    Matrix3 bending_;      // of alpha, times area
    Vector3 rest_angles_;  // from the normal to the directors
};

}  // namespace sheetmorph::surface
