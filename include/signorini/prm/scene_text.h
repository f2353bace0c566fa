// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_prm_scene_text_h
#define signorini_prm_scene_text_h

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace signorini
{
  /** `--set "Section/Subsection/Key=value"`: path of the key and the value. */
  using Override = std::pair<std::string, std::string>;

  /**
   * The comment after which the copy of a scene goes on with what its file does not say: values of
   * the command line, and where files lie. Such statements may set keys again.
   */
  constexpr const char *beyond_the_file = "# Not in the file of the scene, but part of the run.";

  /** `set key = value`, or with an empty key: `subsection` of the last name in @p section. */
  struct Statement
  {
    std::vector<std::string> section; ///< names of the enclosing sections, outermost first
    std::string              key;
    std::string              value;
    std::string              origin;              ///< "scene.prm, line 12" or "scene.prm, --set"
    bool                     is_override = false; ///< from the command line, or once was

    /** `Section/Subsection/Key`. */
    std::string path() const;
  };

  /**
   * A .prm taken apart into statements, in the order of the file, overrides last. The syntax is
   * that of deal.II's ParameterHandler; it is scanned here because a statement must remember its
   * line, so that a check of values, which comes much later, can still name it.
   */
  struct SceneText
  {
    std::string            file_name;
    std::string            original; ///< the file as it was read
    std::vector<Statement> statements;
    std::size_t            n_overrides = 0; ///< so many of the last statements are not in the file

    /**
     * The statement that decides on a key (the last one), or nullptr. An empty key asks for the
     * section.
     */
    const Statement *find(const std::vector<std::string> &section, const std::string &key) const;
  };

  /** Read a file and append the overrides. @throws UserError if it cannot be read or is not a .prm.
   */
  SceneText read_scene_text(const std::string &file_name, const std::vector<Override> &overrides);

  /** The statements of a stream; @p file_name is used for messages and to find included files. */
  std::vector<Statement> scan_statements(std::istream &in, const std::string &file_name);
} // namespace signorini

#endif
