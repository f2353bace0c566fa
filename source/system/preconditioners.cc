// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/system/multilevel.h>
#include <signorini/system/preconditioners.h>

namespace signorini
{
  namespace
  {
    /** The diagonal of the masked matrix. */
    class Jacobi : public MaskedPreconditioner
    {
    public:
      explicit Jacobi(const LinearOperator &matrix, const Vector &like)
      {
        inverse.reinit(like, true);
        matrix.diagonal(inverse);
        for (unsigned int i = 0; i < inverse.locally_owned_size(); ++i)
          inverse.local_element(i) = 1. / inverse.local_element(i);
        masked_inverse = inverse;
      }

      void set_mask(const Mask &mask) override
      {
        for (unsigned int i = 0; i < mask.size(); ++i)
          masked_inverse.local_element(i) = mask[i] ? 0. : inverse.local_element(i);
      }

      void vmult(Vector &destination, const Vector &source) const override
      {
        for (unsigned int i = 0; i < source.locally_owned_size(); ++i)
          destination.local_element(i) = masked_inverse.local_element(i) * source.local_element(i);
      }

    private:
      Vector inverse, masked_inverse;
    };


    /** An incomplete factor, which lives in Cartesian components, seen from contact coordinates. */
    template <int dim, int block_size>
    class ContactIncompleteCholesky : public MaskedPreconditioner
    {
    public:
      ContactIncompleteCholesky(const ElasticMatrices<dim>    &matrices,
                                const ContactCoordinates<dim> &coordinates,
                                const double                   mass_factor,
                                const double                   stiffness_factor)
        : coordinates(coordinates)
        , factor(matrices, mass_factor, stiffness_factor, coordinates.contact_nodes())
        , cartesian(matrices.pattern.partitioner)
      {
      }

      void set_mask(const Mask &mask) override
      {
        held_entries.clear();
        for (unsigned int i = 0; i < mask.size(); ++i)
          if (mask[i])
            held_entries.push_back(i);
        factor.set_held_nodes(coordinates.held_nodes(mask));
      }

      void vmult(Vector &destination, const Vector &source) const override
      {
        cartesian.copy_locally_owned_data_from(source);
        hold(cartesian);
        coordinates.force_to_cartesian(cartesian);
        factor.vmult(destination, cartesian);
        coordinates.displacement_to_contact(destination);
        hold(destination);
      }

    private:
      const ContactCoordinates<dim>      &coordinates;
      IncompleteCholesky<dim, block_size> factor;
      mutable Vector                      cartesian;
      std::vector<unsigned int>           held_entries;

      /** The factor holds rotated entries only to single precision; a multiplier must not leak through, so they become exact zeros. */
      void hold(Vector &vector) const
      {
        for (const unsigned int i : held_entries)
          vector.local_element(i) = 0.;
      }
    };
  } // namespace


  std::string choose_preconditioner(const double courant_number, const unsigned int matrix_life_time)
  {
    if (courant_number < 0.3 || matrix_life_time < 2)
      return "jacobi";
    return courant_number > 60. ? "ml" : "incomplete-cholesky";
  }


  template <int dim>
  std::unique_ptr<MaskedPreconditioner> make_preconditioner(const std::string             &name,
                                                            const ElasticMatrices<dim>    &matrices,
                                                            const ContactCoordinates<dim> &coordinates,
                                                            const double                   mass_factor,
                                                            const double                   stiffness_factor)
  {
    if (name == "jacobi")
      return std::make_unique<Jacobi>(StepOperator<dim>(matrices, coordinates, mass_factor, stiffness_factor),
                                      Vector(matrices.pattern.partitioner));
    if (name == "ml")
      return std::make_unique<Multilevel<dim>>(matrices, coordinates, mass_factor, stiffness_factor);
    return std::make_unique<ContactIncompleteCholesky<dim, dim>>(matrices, coordinates, mass_factor, stiffness_factor);
  }


  template <int dim>
  std::unique_ptr<MaskedPreconditioner> make_mass_preconditioner(const ElasticMatrices<dim>    &matrices,
                                                                 const ContactCoordinates<dim> &coordinates)
  {
    return std::make_unique<ContactIncompleteCholesky<dim, 1>>(matrices, coordinates, 1., 0.);
  }


#define INSTANTIATE(dim)                                                                                               \
  template std::unique_ptr<MaskedPreconditioner> make_preconditioner(                                                  \
    const std::string &, const ElasticMatrices<dim> &, const ContactCoordinates<dim> &, double, double);               \
  template std::unique_ptr<MaskedPreconditioner> make_mass_preconditioner(const ElasticMatrices<dim> &,                \
                                                                          const ContactCoordinates<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
