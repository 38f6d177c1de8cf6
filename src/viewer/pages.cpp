// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewer/pages.h"
#include "io/system/quoting.h"
#include "io/write/Json.h"
#include "io/write/part_labels.h"
#include "viewer/shipped_viewer.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/correspondence_blocks.h>

#include <cstdint>
#include <ostream>
#include <sstream>
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

/// Writes the documents. In JSON, < becomes a code (it occurs in texts only), so that no text ends the script element.
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

using Labels = std::vector<std::string>;

Labels labels_of(const Structural_graph& graph, const std::vector<std::string>& roles)
{
  Labels names;
  for (const Part_abstraction& part : structure(graph).parts)
    names.push_back(part.name);
  return part_labels(names, roles);
}

std::string listed(const std::vector<std::size_t>& parts, const Labels& labels)
{
  Labels of_parts;
  for (std::size_t part : parts)
    of_parts.push_back(labels[part]);
  std::string result;
  for (const std::string& label : with_ranges(of_parts))
    result += (result.empty() ? "" : ", ") + label;
  return result;
}

/// The correspondence in words, with a line for each block.
std::string summary_of(const Correspondence& correspondence, const Labels& source, const Labels& target)
{
  std::string result;
  for (const Correspondence_block& block : correspondence_blocks(correspondence))
    result += (block.role.empty() ? "" : block.role + ": ") + listed(block.source, source) + " → " +
              listed(block.target, target) + " (" + name_of(block.operation) + ")\n";
  return result;
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

Page match_page(const std::vector<Correspondence>& ranked, const Structural_graph& source,
                const Structural_graph& target, const Segmented_shape* source_shape,
                const Segmented_shape* target_shape, const std::string& source_file, const std::string& target_file,
                const Match_seconds& seconds, const Add_scenes& add_scenes)
{
  std::ostringstream json, glb;
  write_correspondences_json(json, ranked, source, target, source_file, target_file, seconds);
  const Page_models models({source_shape, target_shape}, largest_page_triangles);
  write_correspondence_glb(glb, ranked.front(), source, target, models[0], models[1], add_scenes);
  const Labels source_labels = labels_of(source, ranked.front().source_roles),
               target_labels = labels_of(target, ranked.front().target_roles);
  std::ostringstream labels;
  labels << Json::array({source_labels, target_labels}).line();
  return {structure(source).name + " and " + structure(target).name,
          {{"match", json.str()}, {"labels", labels.str()}},
          {{"match.glb", glb.str()}},
          summary_of(ranked.front(), source_labels, target_labels)};
}

void add_blend(Page& page, const std::string& json, const Shape_blend& blend, const Correspondence& correspondence,
               int frames)
{
  std::ostringstream glb;
  write_blend_glb(glb, blend, correspondence, frames);
  page.json.push_back({"blend", json});
  page.glb.push_back({"blend.glb", glb.str()});
}

} // namespace CGAL::Shape_correspondence::IO
