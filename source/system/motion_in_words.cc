// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/system/motion_in_words.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace signorini
{
  namespace
  {
    constexpr double negligible = 1e-3;

    /** "x", "-z", or "(0.6, 0.8)". */
    std::string direction_in_words(const Eigen::VectorXd &direction)
    {
      const Eigen::VectorXd unit = direction.normalized();
      for (Eigen::Index c = 0; c < unit.size(); ++c)
        if (std::abs(unit[c]) > 1. - 0.5 * negligible * negligible)
          return (unit[c] < 0. ? "-" : "") + std::string(1, "xyz"[c]);
      std::ostringstream text;
      text << std::setprecision(3);
      for (Eigen::Index c = 0; c < unit.size(); ++c)
        text << (c == 0 ? "(" : ", ") << (std::abs(unit[c]) < negligible ? 0. : unit[c]);
      return text.str() + ")";
    }
  } // namespace


  template <int dim>
  std::string motion_in_words(const std::vector<std::string> &names,
                              const RigidModes<dim>          &rigid,
                              const Eigen::VectorXd          &amplitudes)
  {
    constexpr unsigned int n = RigidModes<dim>::n_motions;
    AssertDimension(amplitudes.size(), rigid.size());
    const double least = negligible * amplitudes.norm();
    std::string  text;
    for (std::size_t k = 0; k < rigid.bodies().size(); ++k)
      {
        const auto of_body     = amplitudes.segment(n * k, n);
        const auto translation = of_body.head(dim);
        const bool turns       = of_body.tail(n - dim).norm() > least;
        if (of_body.norm() <= least)
          continue;
        text += (text.empty() ? "'" : "; '") + names[rigid.bodies()[k]] + "' ";
        if (translation.norm() > least)
          text += "moves along " + direction_in_words(translation) + (turns ? " and " : "");
        if (!turns)
          continue;
        Eigen::VectorXd rotation = Eigen::VectorXd::Zero(3);
        for (unsigned int which = dim; which < n; ++which)
          for (unsigned int c = 0; c < 3; ++c)
            rotation[c] += of_body[which] * rigid.rotation(n * k + which)[c];
        text += "turns about " + (dim == 2 ? "z" : direction_in_words(rotation));
      }
    return text;
  }


#define INSTANTIATE(dim)                                                                           \
  template std::string motion_in_words(                                                            \
    const std::vector<std::string> &, const RigidModes<dim> &, const Eigen::VectorXd &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
