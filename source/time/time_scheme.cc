// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/time/contact_implicit_newmark.h>
#include <signorini/time/contact_stabilized_newmark.h>
#include <signorini/time/newmark.h>

namespace signorini
{
  std::unique_ptr<TimeScheme> make_time_scheme(const std::string &name)
  {
    if (name == "newmark")
      return std::make_unique<Newmark>();
    if (name == "contact-implicit")
      return std::make_unique<ContactImplicitNewmark>();
    if (name == "contact-stabilized")
      return std::make_unique<ContactStabilizedNewmark>();
    throw UserError("Time/Scheme = " + name + " is not known. Choose newmark, contact-implicit or contact-stabilized.");
  }
} // namespace signorini
