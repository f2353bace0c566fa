// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/scene/read_scene.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>

#include <ostream>

namespace signorini
{
  namespace
  {
    /**
     * A small scene, so that the printed file can be run: lists of names and the step size have no
     * useful default.
     */
    void set_example_values(dealii::ParameterHandler &prm)
    {
      const std::vector<std::pair<std::vector<std::string>, std::pair<std::string, std::string>>>
        values = {{{"Time"}, {"Step size", "5e-3"}},
                  {{"Time"}, {"End time", "0.5"}},
                  {{"Bodies"}, {"Names", "ball"}},
                  {{"Bodies", "ball"}, {"Centre", "0, 0, 1"}},
                  {{"Obstacles"}, {"Names", "floor"}},
                  {{"Contact"}, {"Pairs", "ball : floor"}},
                  {{"Probes"}, {"Names", "south_pole"}}};
      for (const auto &[section, entry] : values)
        {
          for (const std::string &name : section)
            prm.enter_subsection(name);
          prm.set(entry.first, entry.second);
          for (std::size_t i = 0; i < section.size(); ++i)
            prm.leave_subsection();
        }
    }
  } // namespace

  void print_parameters(std::ostream &out)
  {
    dealii::ParameterHandler prm;
    declare_scene<3>(prm, {{"ball"}, {"floor"}, {"south_pole"}, {{"ball", {}, "floor", {}}}});
    set_example_values(prm);
    out << "# All keys of a scene, with descriptions and defaults, for one body, one obstacle and "
           "one probe.\n"
           "# Lists of numbers are separated by commas, the components of expressions by "
           "semicolons.\n"
           "# Units are the user's, consistently.\n#\n";
    prm.print_parameters(
      out, dealii::ParameterHandler::PRM | dealii::ParameterHandler::KeepDeclarationOrder);
  }
} // namespace signorini
