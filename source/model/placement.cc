// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/model/placement.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    /**
     * Cosine and sine of an angle in degrees; exact for multiples of 90, so that boxes keep their
     * straight faces.
     */
    std::array<double, 2> cosine_and_sine(const double degrees)
    {
      const double          turn          = std::fmod(degrees, 360.);
      const double          quarters      = turn / 90.;
      constexpr double      exact_sine[4] = {0., 1., 0., -1.};
      const double          angle         = turn * dealii::numbers::PI / 180.;
      std::array<double, 2> result        = {{std::cos(angle), std::sin(angle)}};
      if (quarters == std::floor(quarters))
        {
          const unsigned int n = static_cast<unsigned int>(quarters + 4.) % 4;
          result               = {{exact_sine[(n + 1) % 4], exact_sine[n]}};
        }
      return result;
    }

    /** Rotation that takes direction @p first to @p second by a quarter turn at 90 degrees. */
    template <int dim>
    dealii::Tensor<2, dim>
    rotation_in_plane(const unsigned int first, const unsigned int second, const double degrees)
    {
      const auto [cosine, sine]     = cosine_and_sine(degrees);
      dealii::Tensor<2, dim> result = dealii::unit_symmetric_tensor<dim>();
      result[first][first]          = cosine;
      result[second][second]        = cosine;
      result[second][first]         = sine;
      result[first][second]         = -sine;
      return result;
    }
  } // namespace

  template <int dim>
  Placement<dim>::Placement()
    : rotation(dealii::unit_symmetric_tensor<dim>())
  {
  }

  template <int dim>
  Placement<dim>::Placement(const std::array<double, n_angles> &degrees,
                            const dealii::Point<dim>           &centre,
                            const dealii::Tensor<1, dim>       &translation)
    : rotation(dealii::unit_symmetric_tensor<dim>())
    , centre(centre)
    , translation(translation)
  {
    for (unsigned int i = 0; i < n_angles; ++i)
      {
        // About x: from y to z; about y: from z to x; about z and out of the plane: from x to y.
        const unsigned int axis = (dim == 2 ? 2 : i);
        rotation = rotation_in_plane<dim>((axis + 1) % 3, (axis + 2) % 3, degrees[i]) * rotation;
      }
    rotates =
      (rotation - dealii::Tensor<2, dim>(dealii::unit_symmetric_tensor<dim>())).norm() != 0.;
  }

  template <int dim>
  dealii::Point<dim> Placement<dim>::place(const dealii::Point<dim> &point) const
  {
    // centre + (point - centre) is not always the point: leave out what does nothing.
    return (rotates ? centre + rotation * (point - centre) : point) + translation;
  }

  template <int dim>
  dealii::Point<dim> Placement<dim>::pull_back(const dealii::Point<dim> &point) const
  {
    const dealii::Point<dim> turned = point - translation;
    return rotates ? centre + transpose(rotation) * (turned - centre) : turned;
  }

  template <int dim>
  dealii::Tensor<1, dim> Placement<dim>::turn(const dealii::Tensor<1, dim> &direction) const
  {
    return rotation * direction;
  }

  template class Placement<2>;
  template class Placement<3>;
} // namespace signorini
