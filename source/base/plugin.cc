// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/plugin.h>
#include <signorini/base/user_error.h>

#include <dlfcn.h>

#include <set>

namespace signorini
{
  namespace
  {
    template <typename Function>
    Function *function_of(void *library, const char *name)
    {
      return reinterpret_cast<Function *>(dlsym(library, name));
    }
  } // namespace


  void load_plugin(const std::string &path)
  {
    static std::set<void *> loaded;
    // Never closed: what it adds lives as long as the program.
    void *const library = dlopen(path.c_str(), RTLD_NOW);
    if (library == nullptr)
      throw UserError("cannot load the library: " + std::string(dlerror())
                      + ". Correct its name, or compile it anew for this program.");
    if (!loaded.insert(library).second)
      return;
    const auto interface = function_of<const char *()>(library, "signorini_plugin_interface");
    const auto begin     = function_of<void()>(library, "signorini_plugin_begin");
    if (interface == nullptr || begin == nullptr)
      throw UserError("the library `" + path
                      + "` is no plug-in. A source of it has to contain SIGNORINI_PLUGIN of "
                        "signorini/base/plugin.h.");
    if (interface() != std::string(plugin_interface))
      throw UserError("the library `" + path + "` was compiled for `" + interface()
                      + "`, and this program is `" + plugin_interface
                      + "`. Compile it anew with the headers of this program.");
    begin();
  }
} // namespace signorini
