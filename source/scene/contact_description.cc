// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/model/body_shape.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    template <typename Description>
    std::vector<std::string> names_of(const std::vector<Description> &descriptions)
    {
      std::vector<std::string> names;
      for (const Description &description : descriptions)
        names.push_back(description.name);
      return names;
    }

    unsigned int index_of(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) - names.begin();
    }

    template <int dim>
    void check_boundary_ids(const SectionReader             &in,
                            const PairName                  &pair,
                            const std::vector<unsigned int> &ids,
                            const BodyDescription<dim>      &body)
    {
      const std::vector<dealii::types::boundary_id> existing = boundary_ids(body);
      std::vector<std::string>                      valid;
      for (const dealii::types::boundary_id id : existing)
        valid.push_back(std::to_string(id));
      for (const unsigned int id : ids)
        if (std::find(existing.begin(), existing.end(), id) == existing.end())
          in.fail("Pairs",
                  "the pair `" + pair.text() + "`: the body `" + body.name + "` (shape "
                    + name_of(body.shape) + ") has no boundary id " + std::to_string(id)
                    + ". Valid: " + join(valid) + ".");
    }

    /** Points of the surface of the slave, for trying expressions. */
    template <int dim>
    std::vector<dealii::Point<dim>> slave_points(const PairDescription      &pair,
                                                 const BodyDescription<dim> &body)
    {
      std::vector<dealii::Point<dim>> points;
      for (const auto id :
           pair.slave_boundary_ids.empty() ? boundary_ids(body) : pair.slave_boundary_ids)
        for (const dealii::Point<dim> &point : boundary_points(body, id))
          points.push_back(point);
      return points;
    }
  } // namespace

  void declare_pair(dealii::ParameterHandler &prm)
  {
    declare_friction(prm);
  }

  template <int dim>
  std::vector<PairDescription>
  parse_pairs(const SectionReader &in, const std::vector<PairName> &names, const Scene<dim> &scene)
  {
    const std::vector<std::string> bodies    = names_of(scene.bodies);
    const std::vector<std::string> obstacles = names_of(scene.obstacles);
    std::vector<PairDescription>   pairs;
    for (const PairName &name : names)
      {
        PairDescription pair;
        pair.name  = name.text();
        pair.slave = index_of(bodies, name.slave);
        check_boundary_ids(in, name, name.ids, scene.bodies[pair.slave]);
        pair.slave_boundary_ids.assign(name.ids.begin(), name.ids.end());
        if (const unsigned int master = index_of(bodies, name.partner); master < bodies.size())
          {
            pair.master = master;
            if (scene.time.mass.predictor == PredictorMass::lumped)
              in.fail("Pairs",
                      "the pair `" + name.text()
                        + "`: the lumped predictor is available for rigid obstacles only. Set "
                        + "`Time/Predictor mass = consistent`.");
            check_boundary_ids(in, name, name.partner_ids, scene.bodies[master]);
            pair.master_boundary_ids.assign(name.partner_ids.begin(), name.partner_ids.end());
          }
        else
          pair.obstacle = index_of(obstacles, name.partner);
        pair.friction = parse_friction<dim>(
          in.section(pair.name), scene.time.scheme, slave_points(pair, scene.bodies[pair.slave]));
        pairs.push_back(pair);
      }
    return pairs;
  }

  template std::vector<PairDescription>
  parse_pairs(const SectionReader &, const std::vector<PairName> &, const Scene<2> &);
  template std::vector<PairDescription>
  parse_pairs(const SectionReader &, const std::vector<PairName> &, const Scene<3> &);
} // namespace signorini
