// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/checked_file.h"
#include "io/system/atomic_file.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace CGAL::Shape_correspondence::IO {

namespace {

std::string heading(const std::string& title, const std::string& content)
{
  return title + ' ' + digest(content) + '\n';
}

} // namespace

std::string digest(const std::string& bytes)
{
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
  return to_string(generator(bytes.data(), bytes.size()));
}

std::string bytes_of_file(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return ""; // opening a pipe would wait for a writer
  std::ifstream in(std::filesystem::path(path), std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

void write_checked_file(const std::string& path, const std::string& title, const std::string& content)
{
  write_atomically(path, [&](std::ostream& out) { out << heading(title, content) << content; });
}

void write_checked_entry(const std::string& path, const std::string& title, const std::string& content)
{
  write_entry(path, [&](std::ostream& out) { out << heading(title, content) << content; });
}

std::optional<std::string> checked_content(const std::string& file, const std::string& title)
{
  const std::size_t line = file.find('\n');
  if (line == std::string::npos) return std::nullopt;
  std::string content = file.substr(line + 1);
  if (file.compare(0, line + 1, heading(title, content)) != 0) return std::nullopt;
  return content;
}

std::optional<std::string> read_checked_file(const std::string& path, const std::string& title)
{
  return checked_content(bytes_of_file(path), title);
}

} // namespace CGAL::Shape_correspondence::IO
