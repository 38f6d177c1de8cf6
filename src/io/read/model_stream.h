// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/model_parts.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace CGAL::Shape_correspondence::IO {

// The output of the program shape_correspondence_import: a mark of its version, a character for the kind of what
// follows, and the content of a model or an error message. Both ends run on the same machine and are of the same build.

constexpr std::string_view import_mark = "shape_correspondence import 4\n";
constexpr char has_content = 'c', has_complaint = 'e';
constexpr int out_of_memory_status = 3; ///< exit status of the program, which then writes nothing

/// Passes the members of a content to a `Content_writer` or a `Content_reader`.
template <typename Stream, typename Content>
void exchange(Stream& stream, Content& content)
{
  const auto value = [&](auto& member) { stream.bytes(&member, sizeof member); };
  const auto values = [&](auto& list) {
    constexpr std::size_t of_element = sizeof(*list.data());
    stream.size(list, of_element);
    stream.bytes(list.data(), list.size() * of_element);
  };
  value(content.faces_left_out);
  value(content.up);
  for (auto* texts : {&content.appearance_warnings, &content.without_faces}) {
    stream.size(*texts, 1);
    for (auto& text : *texts)
      values(text);
  }
  stream.size(content.materials, 1);
  for (auto& material : content.materials) {
    values(material.name);
    value(material.colour);
    value(material.texture);
  }
  stream.size(content.textures, 1);
  for (auto& texture : content.textures) {
    values(texture.name);
    values(texture.bytes);
    value(texture.wrap_u);
    value(texture.wrap_v);
  }
  stream.size(content.parts, 1);
  for (auto& part : content.parts) {
    values(part.name);
    values(part.corners);
    values(part.appearance.materials);
    values(part.appearance.coordinates);
    values(part.appearance.colours);
  }
}

class Content_writer
{
public:
  template <typename List>
  void size(const List& list, std::size_t)
  {
    const std::uint64_t number = list.size();
    bytes(&number, sizeof number);
  }
  void bytes(const void* place, std::size_t size) { text.append(static_cast<const char*>(place), size); }

  std::string text;
};

/// Throws `Invalid_input` if the text is not a valid content.
class Content_reader
{
public:
  explicit Content_reader(std::string_view text) : rest_(text) {}

  /// \param of_element least number of bytes for an element
  template <typename List>
  void size(List& list, std::size_t of_element)
  {
    std::uint64_t number = 0;
    bytes(&number, sizeof number);
    if (number > rest_.size() / of_element) fail();
    list.resize(std::size_t(number));
  }
  void bytes(void* place, std::size_t size)
  {
    if (size > rest_.size()) fail();
    if (size > 0) std::memcpy(place, rest_.data(), size); // an empty vector may have no address
    rest_.remove_prefix(size);
  }

private:
  [[noreturn]] static void fail() { throw Invalid_input("what its reader sends is damaged"); }

  std::string_view rest_;
};

} // namespace CGAL::Shape_correspondence::IO
