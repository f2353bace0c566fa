// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_damping_of_mesh_h
#define signorini_simulation_damping_of_mesh_h

#include <signorini/time/time_scheme.h>

#include <functional>
#include <utility>

namespace signorini
{
  /**
   * A scheme that damps what its steps cannot resolve (TrapezoidalRule), which is a matter of the
   * smallest cells that there are: on meshes that change the damping changes with them. Results do
   * not depend on what schemes keep between steps, so that they may be made anew.
   */
  class DampingOfMesh : public TimeScheme
  {
  public:
    using Maker = std::function<std::unique_ptr<TimeScheme>(double spectral_radius)>;

    explicit DampingOfMesh(Maker maker)
      : make(std::move(maker))
      , scheme(make(radius))
    {
    }

    /** From now on. */
    void use(const double spectral_radius)
    {
      if (spectral_radius == radius)
        return;
      radius = spectral_radius;
      scheme = make(radius);
    }

    double spectral_radius() const { return radius; }

    TakenStep
    make_step(DynamicalSystem &system, const State &start, const double step_size) override
    {
      return scheme->make_step(system, start, step_size);
    }

    void  forget() override { scheme->forget(); }
    Needs needs() const override { return scheme->needs(); }

  private:
    const Maker                 make;
    double                      radius = 1.; ///< no damping
    std::unique_ptr<TimeScheme> scheme;
  };
} // namespace signorini

#endif
