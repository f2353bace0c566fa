// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_base_plugin_h
#define signorini_base_plugin_h

#include <string>

/**
 * What a shared library begins with that adds to the program: it says for which version it was
 * compiled, and what follows, in braces, is called when a scene names the library:
 *
 *     SIGNORINI_PLUGIN
 *     {
 *       signorini::add_scheme(my_scheme());
 *     }
 */
#define SIGNORINI_PLUGIN                                                                           \
  extern "C" const char *signorini_plugin_interface()                                              \
  {                                                                                                \
    return signorini::plugin_interface;                                                            \
  }                                                                                                \
  extern "C" void signorini_plugin_begin()

namespace signorini
{
  /**
   * Version of what a plug-in sees: classes, tables, and the libraries below. A plug-in has to be
   * compiled with the headers of the program that loads it.
   */
  constexpr const char *plugin_interface = SIGNORINI_PLUGIN_INTERFACE;

  /**
   * Load a shared library and let it begin; once, however often it is asked for.
   * @param path absolute
   * @throws UserError if there is no such library, if it is no plug-in, or one for another version
   */
  void load_plugin(const std::string &path);
} // namespace signorini

#endif
