// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/model_parts.h"
#include "io/system/bytes.h"

#include <string_view>

namespace CGAL::Shape_correspondence::IO {

// The output of the program shape_correspondence_import: a mark of its version, a character for the kind of what
// follows, and the content of a model or an error message. Both ends run on the same machine and are of the same build.

constexpr std::string_view import_mark = "shape_correspondence import 5\n";
constexpr char has_content = 'c', has_complaint = 'e';
constexpr int out_of_memory_status = 3; ///< exit status if memory ran out; the program then writes nothing

inline void pass(Value_bytes& bytes, Surface_material& material)
{
  pass_all(bytes, material.name, material.colour, material.texture);
}

inline void pass(Value_bytes& bytes, Texture& texture)
{
  pass_all(bytes, texture.name, texture.bytes, texture.wrap_u, texture.wrap_v);
}

inline void pass(Value_bytes& bytes, Model_part& part)
{
  pass_all(bytes, part.name, part.corners, part.appearance.materials, part.appearance.coordinates,
           part.appearance.colours);
}

inline void pass(Value_bytes& bytes, Model_content& content)
{
  pass_all(bytes, content.faces_left_out, content.up, content.appearance_warnings, content.without_faces,
           content.materials, content.textures, content.parts);
}

} // namespace CGAL::Shape_correspondence::IO
