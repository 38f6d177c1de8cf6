// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/Mapped_matrix.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace CGAL::Shape_correspondence::IO {
namespace {

std::size_t bytes_of(std::size_t size) { return std::max<std::size_t>(1, size * size) * sizeof(double); }

[[noreturn]] void fail_to_map(const std::string& folder, std::size_t bytes, int reason)
{
  const std::string place = folder.empty() ? "memory" : folder;
  throw Invalid_input(place + ": there is no room for a matrix of " + std::to_string(bytes >> 20) + " MB (" +
                      std::strerror(reason) + "); " +
                      (folder.empty() ? "keep it in a folder, by --store" : "choose another folder"));
}

/// A file without a name, with all of its room taken: a full disk would otherwise end the program at any write.
class Nameless_file
{
public:
  Nameless_file(const std::string& folder, std::size_t bytes)
  {
    std::string name = folder + "/matrix.XXXXXX";
    descriptor_ = mkstemp(name.data());
    if (descriptor_ < 0) fail_to_map(folder, bytes, errno);
    unlink(name.c_str());
    const int error = posix_fallocate(descriptor_, 0, off_t(bytes));
    if (error == 0) return;
    close(descriptor_);
    fail_to_map(folder, bytes, error);
  }
  ~Nameless_file() { close(descriptor_); }
  Nameless_file(const Nameless_file&) = delete;
  Nameless_file& operator=(const Nameless_file&) = delete;

  int descriptor() const { return descriptor_; }

private:
  int descriptor_;
};

double* map_of(int descriptor, int flags, const std::string& folder, std::size_t bytes)
{
  void* const begin = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, flags, descriptor, 0);
  if (begin == MAP_FAILED) fail_to_map(folder, bytes, errno);
  return static_cast<double*>(begin);
}

/// A mapped file stays when it is closed.
double* map_zeros(const std::string& folder, std::size_t bytes)
{
  if (folder.empty()) return map_of(-1, MAP_PRIVATE | MAP_ANONYMOUS, folder, bytes);
  const Nameless_file file(folder, bytes);
  return map_of(file.descriptor(), MAP_SHARED, folder, bytes);
}

} // namespace

Mapped_matrix::Mapped_matrix(const std::string& folder, std::size_t size)
    : size_(Eigen::Index(size)), entries_(map_zeros(folder, bytes_of(size)), Unmap{bytes_of(size)})
{}

void Mapped_matrix::Unmap::operator()(double* entries) const { munmap(entries, bytes); }

} // namespace CGAL::Shape_correspondence::IO
