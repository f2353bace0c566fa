// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_elastic_matrices_h
#define signorini_linear_algebra_elastic_matrices_h

#include <signorini/linear_algebra/node_pattern.h>

#include <array>

namespace signorini
{
  /**
   * Matrix-vector products since the start, by matrix: the currency in which the cost of a step is
   * measured.
   */
  struct ProductCount
  {
    unsigned long stiffness = 0; ///< products with A
    unsigned long mass      = 0; ///< products with M
    unsigned long combined  = 0; ///< products with M + s A
  };

  /**
   * Stiffness A and consistent mass M of all bodies on one pattern, in Cartesian components. A has
   * a dim x dim block per pair of nodes, M one number, because the mass is the same in every
   * direction. Both are symmetric, and only the upper triangle is stored: a product is limited by
   * what it reads. Any combination a M + b A is applied in one pass without being stored, so that a
   * new step size costs nothing.
   */
  template <int dim>
  class ElasticMatrices
  {
  public:
    using Block = std::array<double, dim * dim>; ///< column by column

    NodePattern         pattern;
    std::vector<Block>  stiffness; ///< with a spare block at the end, see Lanes
    std::vector<double> mass;      ///< of the time discretisation
    /** The consistent mass where `mass` is a redistributed one; else empty. */
    std::vector<double> standard_mass;
    /** Owned nodes that a redistributed mass leaves without any, ascending. */
    std::vector<unsigned int> massless_nodes;

    /**
     * destination = (mass_factor M + stiffness_factor A) source. Exchanges the ghosts of the
     * source.
     */
    void apply(Vector       &destination,
               const Vector &source,
               double        mass_factor,
               double        stiffness_factor) const;

    void apply_mass(Vector &destination, const Vector &source) const;
    /** The consistent mass, whatever the time discretisation uses. */
    void apply_standard_mass(Vector &destination, const Vector &source) const;
    void apply_stiffness(Vector &destination, const Vector &source) const;

    /** Entry by entry a M + b A for the block at a position of the pattern. */
    Block combined_block(unsigned int position, double mass_factor, double stiffness_factor) const;

    /** Replace M by the diagonal matrix of its row sums. Collective. */
    void lump_mass();

    const ProductCount &products() const { return count; }
    /** Count on from what was done with the matrices of an earlier mesh. */
    void add_products(const ProductCount &earlier)
    {
      count.stiffness += earlier.stiffness;
      count.mass += earlier.mass;
      count.combined += earlier.combined;
    }

  private:
    mutable ProductCount count;
    /** Four numbers per node, see Lanes. */
    mutable std::vector<double> padded_source, padded_destination;

    void apply_with(const std::vector<double> &mass_values,
                    Vector                    &destination,
                    const Vector              &source,
                    double                     mass_factor,
                    double                     stiffness_factor) const;
  };
} // namespace signorini

#endif
