// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_loads_h
#define signorini_discretization_loads_h

#include <signorini/discretization/discretization.h>

#include <functional>

namespace signorini
{
  /**
   * A vector as a function of time, evaluated once if it does not depend on time. The two latest
   * times are kept: the end of a step is the start of the next.
   */
  class VectorInTime
  {
  public:
    /** @param evaluate is called where the vector of a time is not known */
    const Vector &at(double time, bool depends_on_time, const std::function<Vector()> &evaluate);

  private:
    std::array<std::pair<double, Vector>, 2> kept;
    unsigned int                             latest = 0;
  };


  /** The force per mass on the bodies, interpolated at the nodes of one mesh. */
  template <int dim>
  class BodyForce
  {
  public:
    explicit BodyForce(const Discretization<dim> &discretization);

    /** False if there is none on any body. */
    bool any() const { return is_given; }
    bool depends_on_time() const { return has_time; }

    const Vector &at(double time);

  private:
    const Discretization<dim>                &discretization;
    std::vector<std::array<std::string, dim>> expressions; ///< by body
    bool                                      is_given = false, has_time = false;
    VectorInTime                              values;
  };


  /** Nodal forces f(t) of body forces and tractions. */
  template <int dim>
  class Loads
  {
  public:
    explicit Loads(const Discretization<dim> &discretization);

    /** False if no body has any load: then there is nothing to add and no energy of loads. */
    bool any() const { return has_loads; }

    const Vector &at(double time);

  private:
    const Discretization<dim> &discretization;
    BodyForce<dim>             body_force;
    bool                       has_loads, depends_on_time;
    VectorInTime               values;

    Vector assemble(double time);
    /**
     * Add the nodal forces of a condition on the surface of a body.
     * @return whether all tractions on this process are finite numbers
     */
    bool add_traction(unsigned int                  body,
                      const BoundaryCondition<dim> &condition,
                      double                        time,
                      Vector                       &forces) const;
  };
} // namespace signorini

#endif
