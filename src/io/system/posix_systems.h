// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cerrno>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/types.h>
#include <unistd.h>

#ifdef __APPLE__
#include <crt_externs.h>
#include <mach-o/dyld.h>
#endif

// Differences between Linux, macOS and other systems

namespace CGAL::Shape_correspondence::IO {

/// An open file descriptor, closed at the end of its scope.
class Descriptor
{
public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor()
  {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  operator int() const { return number_; }

private:
  int number_;
};

#ifdef __APPLE__

constexpr double units_per_megabyte = 1 << 20;             // unit of ru_maxrss: byte
constexpr short spawn_flags = POSIX_SPAWN_CLOEXEC_DEFAULT; // the started program inherits no files

inline char** environment() { return *_NSGetEnviron(); }

inline std::filesystem::path running_file()
{
  char name[PATH_MAX];
  auto size = std::uint32_t(sizeof name);
  std::error_code error;
  return _NSGetExecutablePath(name, &size) == 0 ? std::filesystem::canonical(name, error) : std::filesystem::path();
}

/// Creates a pipe whose ends started programs do not inherit. \return -1 on failure
inline int make_pipe(int (&ends)[2])
{
  if (pipe(ends) != 0) return -1;
  for (int end : ends)
    fcntl(end, F_SETFD, FD_CLOEXEC);
  return 0;
}

#else

constexpr double units_per_megabyte = 1 << 10; // unit of ru_maxrss: kilobyte
constexpr short spawn_flags = 0;

inline char** environment() { return environ; }

inline std::filesystem::path running_file()
{
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error);
}

/// Creates a pipe whose ends started programs do not inherit. \return -1 on failure
inline int make_pipe(int (&ends)[2]) { return pipe2(ends, O_CLOEXEC); }

#endif

/// Lets a started program inherit only the standard streams, if the system supports that.
inline void close_other_files([[maybe_unused]] posix_spawn_file_actions_t& actions)
{
#if defined(__GLIBC__) && defined(__GLIBC_PREREQ)
#if __GLIBC_PREREQ(2, 34)
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
#endif
#endif
}

} // namespace CGAL::Shape_correspondence::IO
