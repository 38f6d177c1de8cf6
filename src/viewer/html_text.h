// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/Json.h"
#include "io/colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ostream>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// From linear light to what screens are given.
inline std::array<double, 3> screen_colour(const Colour& colour)
{
  std::array<double, 3> result{};
  for (int k = 0; k < 3; ++k) {
    const double c = std::clamp(colour[k], 0., 1.);
    result[static_cast<std::size_t>(k)] = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  }
  return result;
}

/// The same in the notation of style sheets.
inline std::string css_colour(const Colour& colour)
{
  const std::array<double, 3> c = screen_colour(colour);
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", int(255 * c[0] + 0.5), int(255 * c[1] + 0.5),
                int(255 * c[2] + 0.5));
  return text;
}

/// JSON for an element of a page: nothing in it ends the element that holds it.
inline std::string script_text(const Json& json)
{
  std::string result;
  for (char c : json.line())
    result += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return result;
}

/// Text as it stands between tags.
inline std::string html_text(const std::string& text)
{
  std::string result;
  for (char c : text)
    result += c == '<' ? std::string("&lt;") : c == '&' ? std::string("&amp;") : std::string(1, c);
  return result;
}

/// Bytes as the text that pages embed them as.
inline std::string base64(const std::string& bytes)
{
  static constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t triple = 0;
    for (std::size_t k = 0; k < 3; ++k)
      triple = triple << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      result += i + k > bytes.size() ? '=' : digits[triple >> (18 - 6 * k) & 63];
  }
  return result;
}

/// Writes a page that needs no network. Its script finds what it shows in `data`, elements by `$(selector)`, and adds
/// some by `element(tag, text, parent)`.
/// \param style what the page adds to the style that all pages have
/// \param body of the page
inline void write_page(std::ostream& out, const char* title, const char* style, const char* body, const Json& data,
                       const char* script)
{
  out << R"page(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>)page"
      << title << R"page(</title>
<style>
body { margin: 0; height: 100vh; display: flex; font: 14px/1.4 system-ui, sans-serif; color: #222; background: #fff; }
h1 { font-size: 1.2em; margin: .6em 0 .3em; overflow-wrap: anywhere; }
p { margin: .2em 0; }
table { border-collapse: collapse; margin: .6em 0; }
th, td { text-align: left; padding: .15em .6em .15em 0; vertical-align: top; border-bottom: 1px solid #eee; }
tr.lit { background: #ffeeb0; }
i { display: inline-block; width: .8em; height: .8em; border-radius: 2px; }
)page" << style
      << "</style>\n</head>\n<body>\n"
      << body << "<script type=\"application/json\" id=\"data\">" << script_text(data) << R"page(</script>
<script>
'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const $ = s => document.querySelector(s);
const element = (tag, text, parent) => { const e = document.createElement(tag); if (text) e.textContent = text; parent.append(e); return e; };
)page" << script
      << "</script>\n</body>\n</html>\n";
}

} // namespace CGAL::Shape_correspondence::IO
