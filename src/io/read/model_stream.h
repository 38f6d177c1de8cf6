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

// What the program shape_correspondence_import writes: the mark of its version, a character that says what follows, and
// the content of a model, or a complaint. Both ends are of one machine and one build.

constexpr std::string_view import_mark = "shape_correspondence import 1\n";
constexpr char has_content = 'c', has_complaint = 'e';
constexpr int out_of_memory_status = 3; ///< of the program, which then writes nothing

/// Sends the members of a content through a `Content_writer` or a `Content_reader`.
template <typename Stream, typename Content>
void exchange(Stream& stream, Content& content)
{
  stream.number(content.faces_left_out);
  stream.list(content.materials, [&](auto& material) {
    stream.values(material.name);
    stream.bytes(material.colour.data(), sizeof(double) * 4);
    stream.bytes(&material.texture, sizeof material.texture);
  });
  stream.list(content.textures, [&](auto& texture) {
    stream.values(texture.name);
    stream.values(texture.bytes);
    stream.number(texture.wrap_u);
    stream.number(texture.wrap_v);
  });
  stream.list(content.parts, [&](auto& part) {
    stream.values(part.name);
    stream.values(part.corners);
    stream.values(part.appearance.materials);
    stream.values(part.appearance.coordinates);
    stream.values(part.appearance.colours);
  });
}

class Content_writer
{
public:
  template <typename Number>
  void number(const Number& value)
  {
    const auto as_written = static_cast<std::uint64_t>(value);
    bytes(&as_written, sizeof as_written);
  }
  template <typename Values>
  void values(const Values& values)
  {
    number(values.size());
    bytes(values.data(), values.size() * sizeof(*values.data()));
  }
  template <typename List, typename Exchange>
  void list(const List& list, const Exchange& exchange_element)
  {
    number(list.size());
    for (const auto& element : list)
      exchange_element(element);
  }
  void bytes(const void* place, std::size_t size) { text.append(static_cast<const char*>(place), size); }

  std::string text;
};

/// Throws `Invalid_input` where the text is not that of a content.
class Content_reader
{
public:
  explicit Content_reader(std::string_view text) : rest_(text) {}

  template <typename Number>
  void number(Number& value)
  {
    std::uint64_t as_written = 0;
    bytes(&as_written, sizeof as_written);
    value = static_cast<Number>(as_written);
  }
  template <typename Values>
  void values(Values& values)
  {
    values.resize(size(sizeof(*values.data())));
    bytes(values.data(), values.size() * sizeof(*values.data()));
  }
  template <typename List, typename Exchange>
  void list(List& list, const Exchange& exchange_element)
  {
    list.resize(size(1));
    for (auto& element : list)
      exchange_element(element);
  }
  void bytes(void* place, std::size_t size)
  {
    if (size > rest_.size()) fail();
    if (size > 0) std::memcpy(place, rest_.data(), size); // an empty vector may have no place
    rest_.remove_prefix(size);
  }

private:
  [[noreturn]] static void fail() { throw Invalid_input("what its reader sends is damaged"); }

  std::size_t size(std::size_t of_element)
  {
    std::uint64_t result = 0;
    number(result);
    if (result > rest_.size() / of_element) fail();
    return std::size_t(result);
  }

  std::string_view rest_;
};

} // namespace CGAL::Shape_correspondence::IO
