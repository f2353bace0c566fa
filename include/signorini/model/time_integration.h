// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_time_integration_h
#define signorini_model_time_integration_h

#include <string>

namespace signorini
{
  /** What an estimate of the error of a step has to know of the time integration. */
  struct TimeIntegration
  {
    std::string scheme;         ///< name: decides at which instant forces balance
    double      step_size = 0.; ///< of the first step
  };
} // namespace signorini

#endif
