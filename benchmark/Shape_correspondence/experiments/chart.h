// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::experiments {

/// A line chart as SVG.
class Chart
{
public:
  struct Line
  {
    std::string name, colour;
    std::vector<Eigen::Vector2d> points;
    bool dashed = false;
  };

  std::string x_title, y_title;
  std::vector<std::string> x_marks; ///< labels at x = 0, 1, 2, …; empty: numbers
  std::vector<Line> lines;
  double y_low = 0, y_high = 1;

  void write(std::ostream& out) const
  {
    double x_low = 1e300, x_high = -1e300;
    for (const Line& line : lines)
      for (const Eigen::Vector2d& p : line.points) {
        x_low = std::min(x_low, p.x());
        x_high = std::max(x_high, p.x());
      }
    const auto place = [&](const Eigen::Vector2d& p) {
      std::ostringstream text;
      text << left + (p.x() - x_low) / (x_high - x_low) * (width - left - right) << ','
           << height - bottom - (p.y() - y_low) / (y_high - y_low) * (height - top - bottom);
      return text.str();
    };
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
        << "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (int i = 0; i <= 5; ++i) {
      const double y = y_low + i * (y_high - y_low) / 5, x = x_low + i * (x_high - x_low) / 5;
      write_grid_line(out, place({x_low, y}), place({x_high, y}));
      write_text(out, place({x_low, y}), -8, 4, "end", number(y));
      if (x_marks.empty()) write_text(out, place({x, y_low}), 0, 18, "middle", number(x));
    }
    for (std::size_t i = 0; i < x_marks.size(); ++i)
      write_text(out, place({double(i), y_low}), 0, 18, "middle", x_marks[i]);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      out << "<polyline fill=\"none\" stroke=\"" << lines[i].colour << "\" stroke-width=\"2\""
          << (lines[i].dashed ? " stroke-dasharray=\"6 4\"" : "") << " points=\"";
      for (const Eigen::Vector2d& p : lines[i].points)
        out << place(p) << ' ';
      out << "\"/>\n<text x=\"" << left + 12 << "\" y=\"" << top + 16 + 16 * int(i) << "\" fill=\"" << lines[i].colour
          << "\">" << lines[i].name << "</text>\n";
    }
    out << "<text x=\"" << width / 2 << "\" y=\"" << height - 8 << "\" text-anchor=\"middle\">" << x_title
        << "</text>\n<text transform=\"translate(16," << height / 2 << ") rotate(-90)\" text-anchor=\"middle\">"
        << y_title << "</text>\n</svg>\n";
  }

private:
  static constexpr int width = 560, height = 400, left = 64, right = 24, top = 16, bottom = 48;

  static std::string number(double value)
  {
    std::ostringstream text;
    text.precision(3);
    text << value;
    return text.str();
  }

  static void write_grid_line(std::ostream& out, const std::string& from, const std::string& to)
  {
    out << "<polyline stroke=\"#ddd\" points=\"" << from << ' ' << to << "\"/>\n";
  }

  static void write_text(std::ostream& out, const std::string& at, int dx, int dy, const char* anchor,
                         const std::string& text)
  {
    const std::size_t comma = at.find(',');
    out << "<text x=\"" << at.substr(0, comma) << "\" y=\"" << at.substr(comma + 1) << "\" dx=\"" << dx << "\" dy=\""
        << dy << "\" text-anchor=\"" << anchor << "\">" << text << "</text>\n";
  }
};

} // namespace CGAL::Shape_correspondence::experiments
