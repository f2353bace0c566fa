// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_mass_redistributed_h
#define signorini_tests_mass_redistributed_h

#include "../contact/contact_scene.h"

#include <signorini/mass/mass_solver.h>
#include <signorini/mass/redistribute_mass.h>

namespace signorini::tests
{
  /** A scene with a redistributed mass. */
  template <int dim>
  Scene<dim> with_mass(Scene<dim> scene, const std::string &construction)
  {
    scene.time.scheme    = "contact-implicit";
    MassParameters &mass = scene.time.mass;
    mass.kind =
      construction == "zero" ? MassKind::zero_on_contact_boundary : MassKind::redistributed;
    if (mass.kind == MassKind::redistributed)
      mass.redistribution = *value_named<MassRedistribution>(construction);
    return scene;
  }

  /** Everything up to the redistributed mass. */
  template <int dim>
  struct Redistributed : public ContactProblem<dim>
  {
    Redistributed(const Scene<dim> &scene, const std::string &construction)
      : ContactProblem<dim>(with_mass(scene, construction))
      , note(redistribute_mass(this->discretization, this->surface, this->scene.time.mass))
    {
    }

    const std::string note;

    /** x'Mx for the same fields with the mass of the scheme and with the consistent one. */
    std::pair<double, double> both_products(const std::array<std::string, dim> &left,
                                            const std::array<std::string, dim> &right) const
    {
      const Vector x  = field<dim>(this->discretization, left),
                   y  = field<dim>(this->discretization, right);
      Vector standard = this->discretization.make_vector();
      this->discretization.matrices().apply_standard_mass(standard, y);
      return {x * mass_times(this->discretization, y), x * standard};
    }
  };

  /**
   * A box of bricks of different thickness in each direction above a floor; only its lower side
   * may touch.
   */
  template <int dim>
  Scene<dim> box_on_floor(const unsigned int layers)
  {
    BodyDescription<dim> body         = box<dim>();
    box_of(body).repetitions[0]       = 3;
    box_of(body).repetitions[dim - 1] = layers;
    box_of(body).upper_corner[0]      = 2.;
    return contact_scene<dim>(body, {floor_at<dim>(0.)}, {2 * (dim - 1)});
  }
} // namespace signorini::tests

#endif
