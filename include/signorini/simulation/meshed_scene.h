// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_meshed_scene_h
#define signorini_simulation_meshed_scene_h

#include <signorini/scene/scene.h>
#include <signorini/system/elastic_contact_system.h>

#include <memory>
#include <optional>

namespace signorini
{
  /** What a scene says to a system. */
  template <int dim>
  SystemParameters system_parameters(const Scene<dim> &scene, const unsigned int mesh_life_time)
  {
    return {scene.solver, scene.time.mass, mesh_life_time};
  }

  /** On a mesh that stays. */
  template <int dim>
  SystemParameters system_parameters(const Scene<dim> &scene)
  {
    return system_parameters(scene, scene.time.n_steps());
  }

  /**
   * All that is built on one state of the mesh, and built anew when the mesh changes, in the order
   * in which one needs the other.
   */
  template <int dim>
  struct MeshedScene
  {
    /**
     * Collective. @param mesh_life_time see SystemParameters @throws UserError see ContactSurface,
     * redistribute_mass()
     */
    MeshedScene(const Mesh<dim>     &mesh,
                const Scene<dim>    &scene,
                unsigned int         mesh_life_time,
                dealii::TimerOutput &timer);

    /** On the mesh of another one, which ends: all but its matrices is built anew. Collective. */
    MeshedScene(std::unique_ptr<MeshedScene> other,
                const Scene<dim>            &scene,
                unsigned int                 mesh_life_time,
                dealii::TimerOutput         &timer);

  private:
    std::shared_ptr<Discretization<dim>> owned;

  public:
    Discretization<dim>     &discretization;
    DirichletConditions<dim> dirichlet;
    ContactSurface<dim>      surface;
    std::string mass_note; ///< what became of the mass, if that is not the consistent one
    ContactCoordinates<dim>   coordinates;
    Loads<dim>                loads;
    ElasticContactSystem<dim> system;

    /** f at a time, null without loads. */
    const Vector *load(const double time) { return loads.any() ? &loads.at(time) : nullptr; }

    /** Go back to an earlier state: contact that follows has its geometry again. */
    void take_contact_back(const State &earlier)
    {
      if (MovingContact *contact = system.capabilities().moving_contact)
        contact->take_back(earlier);
    }

  private:
    /** Matrices, and the note about their mass; empty: they have not got it yet. */
    using Matrices = std::pair<std::shared_ptr<Discretization<dim>>, std::optional<std::string>>;

    static Matrices taken_from(std::unique_ptr<MeshedScene> other)
    {
      return {other->owned, other->mass_note};
    }

    MeshedScene(Matrices             matrices,
                const Scene<dim>    &scene,
                unsigned int         mesh_life_time,
                dealii::TimerOutput &timer);
  };
} // namespace signorini

#endif
