// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <Eigen/Dense>
#include <array>

namespace sheetmorph::surface
{

//! A triangle of a thin shell (mathematics.md, section 9): constant membrane strain e, whose energy
//! is that of St. Venant and Kirchhoff and grows without bound as the area vanishes, and the
//! constant curvature of Morley's triangle, from how far the director of each side turned about
//! that side against the triangle. Side k runs from corner k to the next.
class ShellElement
{
public:
    using Corners = std::array<Vector3, 3>;

    //! Three corners, then the angles of three directors about their sides.
    using Vector = Eigen::Matrix<double, 12, 1>;
    using Matrix = Eigen::Matrix<double, 12, 12>;

    //! Where the triangle is, and the unit directors of its sides, each at right angles to it.
    struct Place
    {
        Corners corners;
        Corners directors;
    };

    //! What the sheet resists: 2nd Piola-Kirchhoff stress (11, 22, 12), moments of the sides.
    struct Stress
    {
        Vector3 membrane = Vector3::Zero();
        Vector3 moments = Vector3::Zero();
    };

    //! \param poisson  Poisson's ratio
    ShellElement(const Place& rest, double poisson);

    //! mm^2 at rest.
    double area() const { return area_; }

    //! Membrane strain and turned angles in one place, with what derivatives need.
    struct Strain
    {
        Vector3 membrane;               //!< e11, e22, 2 e12
        Vector3 angles;                 //!< alpha, radians
        Eigen::Matrix<double, 3, 2> f;  //!< deformation gradient
        Corners gradients;              //!< of the shape functions now, 1/mm
        Corners sides;                  //!< unit
        Eigen::Vector3d lengths;        //!< of the sides, mm
        Vector3 normal;                 //!< unit
    };
    Strain strain(const Place& place) const;

    //! Energy over E h for a bending factor h^2 / 12, mm^2.
    double energy(const Strain& strain, double bending) const;
    Stress stress(const Strain& strain, double bending) const;

    //! What the stress becomes, to first order, where the triangle moves by `step`.
    Stress predicted(const Strain& strain, double bending, const Vector& step) const;

    Vector gradient(const Strain& strain, double bending) const;

    //! The tangent whose second-order part is that of a given stress.
    Matrix stiffness(const Strain& strain, double bending, const Stress& of_second_order) const;

    //! The part of a stress that pulls and bends nothing: its tangent has no negative direction.
    static Stress tension(const Stress& stress);

private:
    using Rows = Eigen::Matrix<double, 3, 12>;

    //! What resists the loss of area, over the area at rest: energy, stress and tangent by the
    //! membrane strain.
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
