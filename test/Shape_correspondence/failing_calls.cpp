// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// When preloaded into the program, makes one system call on a written file fail with EIO: the call number FAILING_CALL,
// from 1 on, of write(), writev(), fsync(), close() and rename(), or only of the one named FAILING_NAME. Standard
// streams, pipes and files that are read are not counted.

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

template <typename Function>
Function* next(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// Whether this call is to fail.
bool fails(const char* name)
{
  static std::atomic<long> calls{0};
  const char *const wanted = std::getenv("FAILING_CALL"), *const wanted_name = std::getenv("FAILING_NAME");
  if (wanted_name && std::strcmp(wanted_name, name) != 0) return false;
  if (!wanted || ++calls != std::atol(wanted)) return false;
  errno = EIO;
  return true;
}

bool is_written_file(int descriptor)
{
  struct stat status = {};
  return descriptor > STDERR_FILENO && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
         (fcntl(descriptor, F_GETFL) & O_ACCMODE) != O_RDONLY;
}

} // namespace

extern "C" {

ssize_t write(int descriptor, const void* data, std::size_t size)
{
  static auto* const original = next<ssize_t(int, const void*, std::size_t)>("write");
  return is_written_file(descriptor) && fails("write") ? -1 : original(descriptor, data, size);
}

ssize_t writev(int descriptor, const iovec* pieces, int count)
{
  static auto* const original = next<ssize_t(int, const iovec*, int)>("writev");
  return is_written_file(descriptor) && fails("writev") ? -1 : original(descriptor, pieces, count);
}

int fsync(int descriptor)
{
  static auto* const original = next<int(int)>("fsync");
  return fails("fsync") ? -1 : original(descriptor);
}

int close(int descriptor)
{
  static auto* const original = next<int(int)>("close");
  const bool fail = is_written_file(descriptor) && fails("close");
  const int result = original(descriptor); // the file is closed in any case
  if (fail) errno = EIO;
  return fail ? -1 : result;
}

int rename(const char* from, const char* to)
{
  static auto* const original = next<int(const char*, const char*)>("rename");
  return fails("rename") ? -1 : original(from, to);
}

} // extern "C"
