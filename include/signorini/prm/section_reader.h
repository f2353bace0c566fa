// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_prm_section_reader_h
#define signorini_prm_section_reader_h

#include <signorini/base/enum_names.h>
#include <signorini/base/spelling.h>
#include <signorini/prm/scene_text.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/point.h>

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace signorini
{
  /**
   * The values of one section, after deal.II has checked keys and patterns. Whoever refuses a value
   * does it with fail(), which adds the file, the line, the key and the value to the message.
   */
  class SectionReader
  {
  public:
    /** The whole scene; both arguments must outlive the reader. */
    SectionReader(const dealii::ParameterHandler &prm, const SceneText &text);

    /** A section inside of this one. */
    SectionReader section(const std::string &name) const;

    /**
     * Whether file or overrides contain the key; without argument: the section itself or a key in
     * it.
     */
    bool given(const std::string &key) const;
    bool given() const;
    /** Whether the value of the key comes from the command line. */
    bool overridden(const std::string &key) const;

    std::string text(const std::string &key) const;
    /** The value of an enumeration; the key is declared with choices_of(). */
    template <typename Enum>
    Enum choice(const std::string &key) const
    {
      return *value_named<Enum>(text(key));
    }
    /** A path: an absolute one as it is, a relative one from the folder of the scene. */
    std::string path(const std::string &key) const;
    double      number(const std::string &key) const;
    bool        flag(const std::string &key) const;
    /** A number > 0; @p meaning completes the message: "an elastic body resists deformation". */
    double positive_number(const std::string &key, const std::string &meaning) const;
    /** An integer within bounds, both included. */
    unsigned int integer(const std::string &key, unsigned int min, unsigned int max) const;
    /** The largest integer that deal.II reads. */
    static constexpr unsigned int unlimited = std::numeric_limits<int>::max();
    /** Coordinates, separated by commas. */
    template <int dim>
    dealii::Point<dim> point(const std::string &key) const;
    /** `Lower corner` and `Upper corner` of a box that is no plate in any direction. */
    template <int dim>
    std::pair<dealii::Point<dim>, dealii::Point<dim>> corners() const;
    /** Angles of a rotation: one, or three that are separated by commas. */
    template <int dim>
    std::array<double, dim == 2 ? 1 : 3> angles(const std::string &key) const;
    /** Components of a vector of any length but zero. */
    template <int dim>
    dealii::Tensor<1, dim> direction(const std::string &key) const;

    /**
     * @throws UserError about a key and its value, or (empty key) about the section. @p message
     * ends with a remedy.
     */
    [[noreturn]] void fail(const std::string &key, const std::string &message) const;

  private:
    const dealii::ParameterHandler *prm;
    const SceneText                *scene_text;
    std::vector<std::string>        names; ///< of the sections, outermost first
  };

  /** The pattern of a key whose value is one of an enumeration. */
  template <typename Enum>
  dealii::Patterns::Selection choices_of()
  {
    return dealii::Patterns::Selection(join(all_names<Enum>(), "|"));
  }
} // namespace signorini

#endif
