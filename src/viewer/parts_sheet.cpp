// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewer/parts_sheet.h"
#include "viewer/html_text.h"
#include "viewer/shape_picture.h"

#include <ostream>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr int picture_width = 240;         // pixels
constexpr std::size_t most_in_legend = 12; // parts

} // namespace

void Parts_sheet::add(const std::string& title, const Segmented_shape& objects, const Part_split& split,
                      const std::vector<std::string>& lines)
{
  const std::vector<Shape_part>& parts = split.shape.parts();
  const std::vector<Colour> colours = distinct_colours(parts.size());
  figures_ += "<figure><img alt=\"\" src=\"data:image/bmp;base64," +
              base64(shape_picture(split.shape, colours, picture_width)) + "\"><figcaption><b>" + html_text(title) +
              "</b>";
  for (const std::string& line : lines)
    figures_ += "<br>" + html_text(line);
  figures_ += "<br>";
  for (std::size_t i = 0; i < parts.size() && i < most_in_legend; ++i)
    figures_ += "<i style=\"background:" + css_colour(colours[i]) + "\"></i> " + html_text(parts[i].name) + " ";
  if (parts.size() > most_in_legend) figures_ += "…";
  figures_ += "<details><summary>objects</summary>";
  for (std::size_t i = 0; i < split.decisions.size(); ++i)
    figures_ += html_text(objects.parts()[i].name + ": " + split.decisions[i]) + "<br>";
  figures_ += "</details></figcaption></figure>\n";
}

void Parts_sheet::add(const std::string& title, const std::string& complaint)
{
  figures_ +=
      "<figure><figcaption><b>" + html_text(title) + "</b><br>" + html_text(complaint) + "</figcaption></figure>\n";
}

void Parts_sheet::write(std::ostream& out) const
{
  out << R"page(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Parts</title>
<style>
body { margin: 8px; display: flex; flex-wrap: wrap; gap: 8px; font: 12px/1.3 system-ui, sans-serif; color: #222; background: #fff; }
figure { margin: 0; width: 240px; overflow-wrap: anywhere; }
img { display: block; width: 240px; height: 240px; }
i { display: inline-block; width: .8em; height: .8em; border-radius: 2px; }
</style>
</head>
<body>
)page" << figures_
      << "</body>\n</html>\n";
}

} // namespace CGAL::Shape_correspondence::IO
