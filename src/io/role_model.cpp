// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/checked_file.h"
#include "io/input_file.h"
#include "io/shipped_roles.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstddef>
#include <sstream>
#include <streambuf>

namespace CGAL::Shape_correspondence::IO {

namespace {

constexpr const char* model_title = "shape_correspondence role model";

// Reads from memory without a copy of it.
struct Memory_buffer : std::streambuf
{
  Memory_buffer(const char* begin, std::size_t size)
  {
    char* const first = const_cast<char*>(begin); // as std::streambuf wants it; nothing is written
    setg(first, first, first + size);
  }
};

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
  std::ostringstream text;
  text << in.rdbuf();
  const std::optional<std::string> content = checked_content(text.str(), model_title);
  if (!content)
    throw Invalid_input(path +
                        ": it is not a role model, or it is damaged; `shape_correspondence roles train` makes one");
  std::istringstream model(*content);
  return Role_model::read(model, path);
}

std::shared_ptr<const Role_model> shipped_role_model()
{
  static const auto model = std::make_shared<const Role_model>([] {
    // It is part of the program: its digest, which takes as long as the rest, is not looked at
    Memory_buffer bytes(reinterpret_cast<const char*>(shipped_roles), shipped_roles_size);
    std::istream file(&bytes);
    std::string title;
    std::getline(file, title);
    return Role_model::read(file, "the role model of the package");
  }());
  return model;
}

} // namespace CGAL::Shape_correspondence::IO
