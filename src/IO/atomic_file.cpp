// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "atomic_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& why)
{
  const std::string name = path == "-" ? "standard output" : path;
  throw Invalid_input(name + ": it cannot be written (" + why + "); choose another place for the output");
}

/// The file that a path leads to, past symbolic links.
fs::path resolved(const std::string& path)
{
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return error ? fs::path(path) : target;
}

bool is_device(const fs::path& file)
{
  std::error_code error;
  return fs::exists(file, error) && !fs::is_regular_file(file, error) && !fs::is_directory(file, error);
}

/// A file of a new name beside `file`, removed again unless it is renamed.
class Temporary_file
{
public:
  Temporary_file(const std::string& path, const fs::path& file) : path_(path)
  {
    // Other threads and processes may be writing the same file.
    static std::atomic<unsigned> count{0};
    int descriptor = -1;
    while (descriptor < 0) {
      name_ = file.string() + ".tmp" + std::to_string(getpid()) + '_' + std::to_string(count++);
      descriptor = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0666);
      if (descriptor < 0 && errno != EEXIST) fail(path, std::strerror(errno));
    }
    close(descriptor);
  }
  ~Temporary_file()
  {
    if (!renamed_) unlink(name_.c_str());
  }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  const std::string& name() const { return name_; }

  void rename_to(const fs::path& file)
  {
    std::error_code error;
    fs::rename(name_, file, error);
    if (error) fail(path_, error.message());
    renamed_ = true;
  }

private:
  std::string path_;
  std::string name_;
  bool renamed_ = false;
};

void write_directly(const std::string& path, std::ostream& out, const std::function<void(std::ostream&)>& write)
{
  errno = 0;
  write(out);
  out.flush();
  if (!out) fail(path, errno ? std::strerror(errno) : "writing failed");
}

void check_existing(const std::string& path, const fs::path& file)
{
  std::error_code error;
  if (fs::is_directory(file, error)) fail(path, "it is a folder");
  if (fs::exists(file, error) && access(file.c_str(), W_OK) != 0) fail(path, std::strerror(errno));
}

} // namespace

void check_writable(const std::string& path)
{
  if (path == "-") return;
  const fs::path file = resolved(path);
  check_existing(path, file);
  if (!is_device(file)) Temporary_file probe(path, file);
}

void write_atomically(const std::string& path, const std::function<void(std::ostream&)>& write)
{
  if (path == "-") return write_directly(path, std::cout, write);
  const fs::path file = resolved(path);
  check_existing(path, file);
  if (is_device(file)) {
    std::ofstream out(file, std::ios::binary);
    return write_directly(path, out, write);
  }
  Temporary_file temporary(path, file);
  std::ofstream out(temporary.name(), std::ios::binary);
  write_directly(path, out, write);
  out.close();
  temporary.rename_to(file);
}

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL
