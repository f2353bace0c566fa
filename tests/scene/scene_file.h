// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_scene_scene_file_h
#define signorini_tests_scene_scene_file_h

#include "../shapes/shape_of.h"

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/scene/read_scene.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace signorini::tests
{
  /** A file that lives as long as this object. */
  class TemporaryFile
  {
  public:
    explicit TemporaryFile(const std::string &text, const std::string &extension = ".prm")
    {
      static int counter = 0;
      name               = testing::TempDir() + "scene_" + std::to_string(getpid()) + "_"
             + std::to_string(counter++) + extension;
      std::ofstream(name) << text;
    }
    TemporaryFile(const TemporaryFile &) = delete;
    ~TemporaryFile() { std::remove(name.c_str()); }

    std::string name;
  };

  /** A correct scene: a ball and a box above a floor. */
  inline std::string correct_scene()
  {
    return R"(set Dimension        = 3
set Output directory = output/test
subsection Time
  set Step size = 5e-3
  set End time  = 0.5
end
subsection Bodies
  set Names = ball, box
  subsection ball
    set Shape            = ball
    set Centre           = 0, 0, 1
    set Radius           = 1
    set Refinements      = 2
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 2
    set Initial velocity = 0; 0; -2*z     # a comment
  end
  subsection box
    set Shape        = box
    set Lower corner = 2, 0, 0.5
    set Upper corner = 3, 1, 1.5
    set Repetitions  = 1, 2, 3
    set Dirichlet    = 0: 0; -; - | 1: 0; 0; 0.1*sin(pi*t)
    set Traction     = 5: 0; 0; if(x > 2.5 || y > 0.5, -t, 0)
    set Body force   = 0; 0; -9.81
  end
end
subsection Obstacles
  set Names = floor, pillar
  subsection floor
    set Shape  = plane
    set Normal = 0, 0, 1
  end
  subsection pillar
    set Shape  = sphere
    set Centre = 2.5, 0.5, -1
    set Radius = 0.9
  end
end
subsection Contact
  set Pairs = ball:floor, box[2,4] : pillar
  subsection ball  : floor
    set Friction coefficient = 0
  end
  subsection box[2, 4] : pillar
  end
end
subsection Probes
  set Names = south
  subsection south
    set Point = 0, 0, 0
  end
end
)";
  }

  /**
   * A file that includes a scene and changes it: within one file, no key may be set twice.
   */
  struct ChangedScene
  {
    ChangedScene(const std::string &scene, const std::string &changes)
      : base(scene)
      , file("include " + base.name + "\n" + changes)
    {
    }

    TemporaryFile base, file;
  };

  /** One more `set`, written as a file would have it. */
  inline std::string assignment(const std::string &path, const std::string &value)
  {
    std::vector<std::string> names = split(path, '/');
    const std::string        key   = names.back();
    names.pop_back();
    std::string text;
    for (const std::string &name : names)
      text += "subsection " + name + "\n";
    text += "set " + key + " = " + value + "\n";
    for (std::size_t i = 0; i < names.size(); ++i)
      text += "end\n";
    return text;
  }

  inline void expect_words(const std::string &message, const std::vector<std::string> &words)
  {
    for (const std::string &word : words)
      EXPECT_NE(message.find(word), std::string::npos) << "`" << word << "` is not in: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }

  /** The message of the UserError with which a file is refused; empty if it is read. */
  inline std::string refusal(const std::string           &file_name,
                             const std::vector<Override> &overrides = {})
  {
    try
      {
        if (read_dimension(file_name, overrides) == 2)
          read_scene<2>(file_name, overrides);
        else
          read_scene<3>(file_name, overrides);
      }
    catch (const UserError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace signorini::tests

#endif
