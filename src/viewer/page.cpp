// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/quoting.h"
#include "viewer/match_page.h"
#include "viewer/shipped_viewer.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstdint>
#include <ostream>
#include <string_view>

namespace CGAL::Shape_correspondence::IO {
namespace {

std::string_view text_of(const unsigned char* bytes, std::size_t size)
{
  return {reinterpret_cast<const char*>(bytes), size};
}

std::string base64(std::string_view bytes)
{
  static constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t triple = 0;
    for (std::size_t k = 0; k < 3; ++k)
      triple = triple << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      result += i + k > bytes.size() ? '=' : digits[triple >> (18 - 6 * k) & 63];
  }
  return result;
}

/// JSON has < in texts only, where it may be written as a code: so nothing ends the element that holds it.
void write_documents(std::ostream& out, const Page& page)
{
  for (const Page::Document& document : page.json) {
    out << "<script type=\"application/json\" id=\"" << document.id << "\">";
    for (char c : document.content)
      c == '<' ? out << "\\u003c" : out << c;
    out << "</script>\n";
  }
  for (const Page::Document& document : page.glb)
    out << "<script type=\"model/gltf-binary\" id=\"" << document.id << "\">" << base64(document.content)
        << "</script>\n";
}

void write_text(std::ostream& out, const std::string& text)
{
  for (char c : utf8_text(text))
    c == '<' ? out << "&lt;" : c == '&' ? out << "&amp;" : out << c;
}

} // namespace

void write_page(std::ostream& out, const Page& page)
{
  if (!shipped_viewer_is_complete)
    throw Invalid_input("web pages are not available: the program was built without three.js; install that and build "
                        "it again (see README.md)");
  std::string_view rest = text_of(shipped_viewer_page, shipped_viewer_page_size);
  for (std::size_t begin; (begin = rest.find('@')) != std::string_view::npos;) {
    const std::size_t end = rest.find('@', begin + 1);
    const std::string_view place = rest.substr(begin + 1, end - begin - 1);
    out << rest.substr(0, begin);
    if (place == "HASH") out << base64(text_of(shipped_viewer_hash, shipped_viewer_hash_size));
    if (place == "TITLE") write_text(out, page.title);
    if (place == "SUMMARY") write_text(out, page.summary);
    if (place == "STYLE") out << text_of(shipped_viewer_style, shipped_viewer_style_size);
    if (place == "DOCUMENTS") write_documents(out, page);
    if (place == "SCRIPT") out << text_of(shipped_viewer_script, shipped_viewer_script_size);
    rest.remove_prefix(end + 1);
  }
  out << rest;
}

} // namespace CGAL::Shape_correspondence::IO
