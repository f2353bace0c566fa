// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/build_information.h>
#include <signorini/prm/new_scene.h>
#include <signorini/prm/plugins.h>
#include <signorini/program/print_information.h>
#include <signorini/scene/explain_key.h>
#include <signorini/scene/read_scene.h>
#include <signorini/schemes/scheme_table.h>

#include <iostream>

namespace signorini
{
  void print_information(const CommandLine &options)
  {
    load_plugins(options.scene_file.empty()
                   ? plugins_without_a_scene(options.overrides)
                   : read_scene_text(options.scene_file, options.overrides));
    if (options.help)
      std::cout << help();
    else if (options.version)
      std::cout << version_and_commit();
    else if (options.new_scene)
      std::cout << write_new_scene(*options.new_scene);
    else if (!options.explain.empty())
      explain_key(options.explain, std::cout);
    else if (options.print_parameters)
      print_parameters(std::cout);
    else if (options.print_schemes)
      (options.as_json ? print_schemes_as_json : print_schemes)(std::cout);
    else
      std::cout << short_help();
  }
} // namespace signorini
