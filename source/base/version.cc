// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/build_information.h>

#include <signorini_build.h>

namespace signorini
{
  std::string commit()
  {
    return SIGNORINI_COMMIT;
  }


  std::string version()
  {
    return "signorini " SIGNORINI_VERSION " (deal.II " SIGNORINI_DEALII_VERSION ")\n";
  }


  std::string version_and_commit()
  {
    return "signorini " SIGNORINI_VERSION ", commit " + commit()
           + " (deal.II " SIGNORINI_DEALII_VERSION ")\n";
  }
} // namespace signorini
