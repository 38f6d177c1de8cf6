// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/document.h"
#include "io/read/shipped_roles.h"
#include "io/system/atomic_file.h"
#include "io/system/input_file.h"
#include "roles/Role_model_data.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstdint>
#include <sstream>
#include <string_view>
#include <utility>

namespace CGAL::Shape_correspondence::IO {

namespace {

constexpr const char* model_title = "shape_correspondence role model";

internal::Stored_bytes bytes_of(std::string_view text, std::shared_ptr<const void> owner)
{
  const auto* const begin = reinterpret_cast<const std::uint8_t*>(text.data());
  return {begin, begin + text.size(), std::move(owner)};
}

} // namespace

void write_role_model(const std::string& path, const Role_model& model)
{
  std::ostringstream content;
  model.write(content);
  write_checked_file(path, model_title, content.str());
}

Role_model read_role_model(const std::string& path)
{
  std::ifstream in = open_input(path);
  const std::optional<std::string> content = checked_content(read_document(in, path), model_title);
  if (!content)
    throw Invalid_input(path +
                        ": it is not a role model, or it is damaged; train one by `shape_correspondence roles train`");
  const auto bytes = std::make_shared<const std::string>(*content);
  return internal::Role_model_access::model(internal::read_role_model_data(bytes_of(*bytes, bytes), path));
}

std::shared_ptr<const Role_model> shipped_role_model()
{
  static const auto model = std::make_shared<const Role_model>([] {
    // The digest is not checked: the bytes are part of the program, and the check would double the time
    std::string_view bytes(reinterpret_cast<const char*>(shipped_roles), shipped_roles_size);
    bytes.remove_prefix(bytes.find('\n') + 1);
    return internal::Role_model_access::model(
        internal::read_role_model_data(bytes_of(bytes, nullptr), "the role model of the package"));
  }());
  return model;
}

} // namespace CGAL::Shape_correspondence::IO
