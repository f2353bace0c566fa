// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/strain_modes.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    using Modes = std::vector<StrainMode>;

    Modes no_modes(const int)
    {
      return {};
    }

    /** Those of Wilson: without them a cell in bending answers with shear. */
    Modes incompatible_modes(const int dim)
    {
      Modes modes;
      for (int k = 0; k < dim; ++k)
        for (int c = 0; c < dim; ++c)
          modes.push_back({1u << k, unsigned(k), unsigned(c)});
      return modes;
    }

    /** One change of volume less for each product of several 2 xi_k - 1. */
    Modes with_isotropic_products(Modes modes, const int dim, const unsigned int least_factors)
    {
      for (unsigned int polynomial = 1; polynomial < 1u << dim; ++polynomial)
        {
          unsigned int n_factors = 0;
          for (int k = 0; k < dim; ++k)
            n_factors += polynomial >> k & 1;
          if (n_factors >= least_factors)
            modes.push_back({polynomial, StrainMode::isotropic, 0});
        }
      return modes;
    }

    /**
     * In the plane the modes of Wilson free all changes of volume but the mean one, because j div u
     * is linear on the reference cell. In space it has products, too: with them one constraint per
     * cell is left (@cite simo_armero_taylor_1993 takes three of the four; the fourth is for cells
     * that are no parallelepipeds, which lock without it as nu comes close to 1/2).
     */
    Modes enhanced_modes(const int dim)
    {
      return dim == 2 ? incompatible_modes(2)
                      : with_isotropic_products(incompatible_modes(3), 3, 2);
    }

    /**
     * With as many isotropic modes as there are Gauss points but one, the change of volume at all
     * of them becomes the mean one, at no price in shear @cite hughes_1980.
     */
    Modes mean_dilatation_modes(const int dim)
    {
      return with_isotropic_products({}, dim, 1);
    }

    struct ElementRow
    {
      ElementKind kind;
      Modes (*modes)(int dim);
    };

    constexpr ElementRow element_table[] = {{ElementKind::standard, no_modes},
                                            {ElementKind::enhanced, enhanced_modes},
                                            {ElementKind::mean_dilatation, mean_dilatation_modes}};
  } // namespace


  template <int dim>
  const std::vector<StrainMode> &strain_modes(const ElementKind element)
  {
    static const auto all = [] {
      std::array<Modes, std::size(element_table)> result;
      for (const ElementRow &row : element_table)
        result[static_cast<std::size_t>(row.kind)] = row.modes(dim);
      return result;
    }();
    return all[static_cast<std::size_t>(element)];
  }


  template <int dim>
  dealii::Tensor<2, dim> mode_matrix(const StrainMode             &mode,
                                     const dealii::Tensor<2, dim> &cofactors)
  {
    dealii::Tensor<2, dim> result;
    if (mode.direction == StrainMode::isotropic)
      {
        // An area, as the cofactors: their determinant is that of the map to the power dim - 1.
        const double area = std::pow(std::abs(determinant(cofactors)), 1. / dim);
        for (unsigned int c = 0; c < dim; ++c)
          result[c][c] = area;
      }
    else
      result[mode.component] = cofactors[mode.direction];
    return result;
  }


  template const std::vector<StrainMode> &strain_modes<2>(ElementKind);
  template const std::vector<StrainMode> &strain_modes<3>(ElementKind);
  template dealii::Tensor<2, 2> mode_matrix(const StrainMode &, const dealii::Tensor<2, 2> &);
  template dealii::Tensor<2, 3> mode_matrix(const StrainMode &, const dealii::Tensor<2, 3> &);
} // namespace signorini
