// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/model/placed_body.h>
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

    /** The boundary ids of numbers and names. */
    template <int dim>
    std::vector<dealii::types::boundary_id>
    parse_boundary_ids(const SectionReader            &in,
                       const PairName                 &pair,
                       const std::vector<std::string> &words,
                       const BodyDescription<dim>     &body)
    {
      std::vector<dealii::types::boundary_id> result;
      for (const std::string &word : words)
        {
          const auto ids = boundary_ids_named(*body.shape, word);
          if (ids.empty())
            in.fail("Pairs",
                    "the pair `" + pair.text() + "`: the body `" + body.name + "` (shape "
                      + body.shape_name + ") has no boundary id " + word
                      + ". Valid: " + list_of_boundaries(*body.shape) + ".");
          for (const dealii::types::boundary_id id : ids)
            if (std::find(result.begin(), result.end(), id) == result.end())
              result.push_back(id);
        }
      return result;
    }

    std::vector<std::string> in_words(const std::vector<dealii::types::boundary_id> &ids)
    {
      std::vector<std::string> words;
      for (const dealii::types::boundary_id id : ids)
        words.push_back(std::to_string(id));
      return words;
    }

    /** What names hide until the meshes are read: two pairs of the same faces. */
    void check_that_none_is_twice(const SectionReader                &in,
                                  const std::vector<PairName>        &names,
                                  const std::vector<PairDescription> &pairs)
    {
      std::vector<PairName> numbered = names;
      for (std::size_t p = 0; p < names.size(); ++p)
        {
          numbered[p].ids         = in_words(pairs[p].slave_boundary_ids);
          numbered[p].partner_ids = in_words(pairs[p].master_boundary_ids);
          for (std::size_t other = 0; other < p; ++other)
            if (overlap(numbered[p], numbered[other]))
              in.fail("Pairs",
                      "`" + names[other].text() + "` and `" + names[p].text()
                        + "` are the same contact twice. Remove one of them.");
        }
    }

    /** Points of the surface of the slave, for trying expressions. */
    template <int dim>
    std::vector<dealii::Point<dim>> slave_points(const PairDescription      &pair,
                                                 const BodyDescription<dim> &body)
    {
      std::vector<dealii::Point<dim>> points;
      for (const auto id :
           pair.slave_boundary_ids.empty() ? body.shape->boundary_ids() : pair.slave_boundary_ids)
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
        pair.name               = name.text();
        pair.slave              = index_of(bodies, name.slave);
        pair.slave_boundary_ids = parse_boundary_ids(in, name, name.ids, scene.bodies[pair.slave]);
        if (const unsigned int master = index_of(bodies, name.partner); master < bodies.size())
          {
            pair.master = master;
            if (scene.time.mass.predictor == PredictorMass::lumped)
              in.fail("Pairs",
                      "the pair `" + name.text()
                        + "`: the lumped predictor is available for rigid obstacles only. Set "
                        + "`Time/Predictor mass = consistent`.");
            pair.master_boundary_ids =
              parse_boundary_ids(in, name, name.partner_ids, scene.bodies[master]);
          }
        else
          pair.obstacle = index_of(obstacles, name.partner);
        pair.friction = parse_friction<dim>(
          in.section(pair.name), scene.time.scheme, slave_points(pair, scene.bodies[pair.slave]));
        pairs.push_back(pair);
      }
    check_that_none_is_twice(in, names, pairs);
    return pairs;
  }

  template std::vector<PairDescription>
  parse_pairs(const SectionReader &, const std::vector<PairName> &, const Scene<2> &);
  template std::vector<PairDescription>
  parse_pairs(const SectionReader &, const std::vector<PairName> &, const Scene<3> &);
} // namespace signorini
