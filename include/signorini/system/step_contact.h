// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_step_contact_h
#define signorini_system_step_contact_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/time/dynamical_system.h>

#include <deque>
#include <functional>
#include <memory>

namespace signorini
{
  template <int dim>
  class FollowedContact;

  /**
   * Contact that follows the motion, as steps need it: contact coordinates turn with the normals,
   * and the motion that a step is expected to make continues the last ones.
   */
  template <int dim>
  class StepContact : public MovingContact
  {
  public:
    /**
     * All must outlive the object.
     * @param held per contact node of this process whether the latest solutions hold it
     */
    StepContact(const Discretization<dim>                &discretization,
                const DirichletConditions<dim>           &dirichlet,
                ContactSurface<dim>                      &surface,
                ContactCoordinates<dim>                  &coordinates,
                const std::function<std::vector<bool>()> &held);
    ~StepContact() override;

    void   arrive(const Vector &displacement, double time) override;
    void   return_to(const State &start, const State &end) override;
    void   take_back(const State &start) override;
    void   begin_step(const State &start, double step_size, StepNormals normals) override;
    void   follow(const Vector &increment) override;
    void   let_steps_be_trials(bool they_are) override { is_tried = they_are; }
    bool   steps_are_trials() const override { return is_tried; }
    bool   repeats() const override { return is_repetition; }
    double mismatch(const Vector &increment) override;
    bool   passes_through(const Vector &increment) const override;
    const std::vector<unsigned int> &entries() const override { return entries_of_contact; }
    const Vector                    *obstacle_motion() const override;
    double                           geometry_work(const Vector &contact_force) const override;
    NormalGap tangential_approach(const Vector &free_increment) const override;
    void      face_end(const Vector &increment) override;
    void      face_motion() override;

    /**
     * The motion of the obstacles along the tangents on which friction acts, in contact
     * coordinates: what increments have beyond the slip. Empty where nothing moves.
     */
    Vector drag() const;

    /** Per contact node of this process. */
    NormalGap gaps_at_start() const;

  private:
    ContactCoordinates<dim>                 &coordinates;
    const ContactSurface<dim>               &surface;
    std::unique_ptr<FollowedContact<dim>>    geometry;
    const std::function<std::vector<bool>()> held;
    std::vector<unsigned int>                entries_of_contact;
    bool                                     is_repetition = false, is_tried = false;
    StepNormals                              latest_normals = StepNormals::of_motion;
    Vector                                   motion_of_obstacles;

    /** Where the contact nodes were when the latest steps began, latest first. */
    struct Moment
    {
      double              time;
      std::vector<double> displacement; ///< of entries()
    };
    std::deque<Moment> moments;

    Vector expected_increment(const State &start, double step_size);
    void   take_over_geometry();
  };
} // namespace signorini

#endif
