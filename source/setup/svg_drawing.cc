// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/setup/svg_drawing.h>

#include <algorithm>
#include <sstream>

namespace signorini
{
  using dealii::Point;

  namespace
  {
    constexpr double width = 1000., most_height = 800., margin = 30., legend_width = 240.,
                     line_height = 24.;

    std::string in_xml(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
      return result;
    }


    std::string attributes(const SvgDrawing::Style &style)
    {
      std::ostringstream text;
      text << " fill=\"" << (style.fill.empty() ? "none" : style.fill) << '"';
      if (style.opacity < 1.)
        text << " fill-opacity=\"" << style.opacity << '"';
      if (!style.stroke.empty())
        text << " stroke=\"" << style.stroke << "\" stroke-width=\"" << style.width
             << "\" stroke-linejoin=\"round\"";
      return text.str();
    }


    double scale_of(const dealii::BoundingBox<2> &view)
    {
      const auto &[low, high] = view.get_boundary_points();
      return std::min((width - legend_width - 2. * margin) / (high[0] - low[0]),
                      (most_height - 2. * margin) / (high[1] - low[1]));
    }
  } // namespace


  SvgDrawing::SvgDrawing(const dealii::BoundingBox<2> &view, const std::string &title)
    : view(view)
    , scale(scale_of(view))
    , elements("<title>" + in_xml(title) + "</title>\n")
  {
  }


  std::string SvgDrawing::place(const Point<2> &point) const
  {
    const auto &[low, high] = view.get_boundary_points();
    std::ostringstream text;
    text.precision(2);
    text << std::fixed << margin + scale * (point[0] - low[0]) << ','
         << margin + scale * (high[1] - point[1]);
    return text.str();
  }


  void SvgDrawing::polygon(const std::vector<Point<2>> &points, const Style &style)
  {
    elements += "<polygon clip-path=\"url(#view)\" points=\"";
    for (const Point<2> &point : points)
      elements += (&point == &points.front() ? "" : " ") + place(point);
    elements += '"' + attributes(style) + "/>\n";
  }


  void SvgDrawing::label(const Point<2> &point, const std::string &text, const bool is_small)
  {
    const std::string at = place(point);
    elements += "<text x=\"" + at.substr(0, at.find(',')) + "\" y=\"" + at.substr(at.find(',') + 1)
                + "\" font-size=\"" + (is_small ? "12" : "17")
                + "\" text-anchor=\"middle\" dominant-baseline=\"middle\" paint-order=\"stroke\" "
                  "stroke=\"#ffffff\" stroke-width=\"3\" fill=\"#222222\">"
                + in_xml(text) + "</text>\n";
  }


  void SvgDrawing::legend(const Style &style, const std::string &text)
  {
    std::ostringstream out;
    const double       x = width - legend_width, y = margin + line_height * n_legends++;
    if (!style.fill.empty() || !style.stroke.empty())
      out << "<rect x=\"" << x << "\" y=\"" << y << "\" width=\"18\" height=\"14\""
          << attributes(style) << "/>";
    out << "<text x=\"" << x + 26. << "\" y=\"" << y + 12. << "\" font-size=\"14\">" << in_xml(text)
        << "</text>\n";
    elements += out.str();
  }


  std::string SvgDrawing::text() const
  {
    const double height =
      2. * margin + std::max(scale * view.side_length(1), line_height * n_legends);
    std::ostringstream out;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
        << "\" width=\"" << width << "\" height=\"" << height
        << "\" font-family=\"sans-serif\" role=\"img\">\n"
        << "<rect width=\"" << width << "\" height=\"" << height << "\" fill=\"#ffffff\"/>\n"
        << "<clipPath id=\"view\"><rect width=\"" << width - legend_width - 5. << "\" height=\""
        << height << "\"/></clipPath>\n"
        << elements << "</svg>\n";
    return out.str();
  }
} // namespace signorini
