// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_elastic_matrices_h
#define signorini_linear_algebra_elastic_matrices_h

#include <signorini/base/rayleigh_damping.h>
#include <signorini/linear_algebra/node_pattern.h>

#include <array>

namespace signorini
{
  /**
   * Matrix-vector products since the start, by matrix: the currency in which the cost of a step is
   * measured. Those with vectors that are zero at nearly all nodes count by the part of the matrix
   * that they read.
   */
  struct ProductCount
  {
    unsigned long stiffness = 0; ///< products with A
    unsigned long mass      = 0; ///< products with M
    unsigned long combined  = 0; ///< products with M + s A
  };

  /** The factors of a sum of the mass M, the stiffness A and the damping C. */
  struct MatrixSum
  {
    double mass;
    double stiffness;
    double damping = 0.;

    /** Whether the sum is definite, for a body that is held. */
    bool is_positive() const
    {
      return mass >= 0. && stiffness >= 0. && damping >= 0. && mass + stiffness > 0.;
    }
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
    /**
     * Of the body of each local node; empty where no body is damped. C of a body is a sum of its M
     * and A and needs no matrix of its own.
     */
    std::vector<RayleighDamping> damping;
    /** Owned nodes that a redistributed mass leaves without any, ascending. */
    std::vector<unsigned int> massless_nodes;

    /**
     * destination = (sum of matrices) source. Exchanges the ghosts of the source. C comes with A
     * only; for C alone see apply_damping().
     */
    void apply(Vector &destination, const Vector &source, const MatrixSum &sum) const;

    void apply_mass(Vector &destination, const Vector &source) const;
    /** The consistent mass, whatever the time discretisation uses. */
    void apply_standard_mass(Vector &destination, const Vector &source) const;
    void apply_stiffness(Vector &destination, const Vector &source) const;

    /** C source: two products. */
    void apply_damping(Vector &destination, const Vector &source) const;

    /** The sum for the block at a position of the row of a node. */
    Block combined_block(unsigned int node, unsigned int position, const MatrixSum &sum) const;

    /** C resolved: the factors of M and A in the row of a local node. */
    MatrixSum at_node(const unsigned int node, const MatrixSum &sum) const
    {
      if (!is_damped(sum))
        return {sum.mass, sum.stiffness};
      return {sum.mass + sum.damping * damping[node].mass,
              sum.stiffness + sum.damping * damping[node].stiffness};
    }

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

    /** Count on from another number; of a product that is half done nothing is left. */
    void set_products(const ProductCount &products)
    {
      count  = products;
      n_read = ProductCount();
    }

  private:
    mutable ProductCount count, n_read; ///< products, and blocks of the next ones
    /** Four numbers per node, see Lanes. */
    mutable std::vector<double> padded_source, padded_destination;
    /** Per local node whether the source is not zero there; empty if it is at many. */
    mutable std::vector<char> moved;

    void apply_with(const std::vector<double> &mass_values,
                    Vector                    &destination,
                    const Vector              &source,
                    const MatrixSum           &sum) const;

    void find_moved_nodes() const;

    /** The product of the padded vectors over the factor of A, or that of M without A. */
    void multiply_padded(const std::vector<double> &mass_values, const MatrixSum &sum) const;

    bool is_damped(const MatrixSum &sum) const { return sum.damping > 0. && !damping.empty(); }
  };
} // namespace signorini

#endif
