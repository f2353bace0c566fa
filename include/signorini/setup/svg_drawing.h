// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_setup_svg_drawing_h
#define signorini_setup_svg_drawing_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace signorini
{
  /**
   * A drawing in Scalable Vector Graphics 1.1 of what lies in a rectangle of the plane, in its own
   * units, with room at its right for a legend. Ordinates grow upwards. What is drawn later covers
   * what is there.
   */
  class SvgDrawing
  {
  public:
    /** @param title for who cannot see the picture */
    SvgDrawing(const dealii::BoundingBox<2> &view, const std::string &title);

    /** Colours are `#rrggbb`; an empty one draws nothing. @param opacity of the fill, 0 to 1 */
    struct Style
    {
      std::string fill, stroke;
      double      width   = 0.5; ///< of the line, in parts of 1/1000 of the drawing's width
      double      opacity = 1.;
    };

    /** A closed polygon; of two points a line. */
    void polygon(const std::vector<dealii::Point<2>> &points, const Style &style);

    /** A text with its middle at a point. Any characters may be in it. */
    void label(const dealii::Point<2> &point, const std::string &text, bool is_small);

    /** The next line of the legend, with a patch of the style in front of it unless that draws
     * nothing. */
    void legend(const Style &style, const std::string &text);

    /** The whole file. */
    std::string text() const;

  private:
    const dealii::BoundingBox<2> view;
    const double                 scale; ///< units of the drawing per length
    std::string                  elements;
    unsigned int                 n_legends = 0;

    std::string place(const dealii::Point<2> &point) const;
  };
} // namespace signorini

#endif
