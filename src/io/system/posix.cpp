// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/atomic_file.h"
#include "io/system/operating_system.h"
#include "io/system/posix_systems.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/resource.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace CGAL::Shape_correspondence::IO {
namespace {

namespace fs = std::filesystem;

std::error_code error_of(int number) { return {number, std::generic_category()}; }
std::error_code last_error_if(bool failed) { return failed ? error_of(errno) : std::error_code(); }

/// Opens standard streams that are closed, in the mode in which their use fails; else other files would get the output.
void reserve_standard_streams()
{
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1) open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/// On signals that end the program, removes its temporary files first. A thread waits for the signals, since a handler
/// may not remove folders; all other threads, which start later, block these signals.
void remove_temporaries_at_signals()
{
#ifndef __EMSCRIPTEN__
  static sigset_t signals;
  sigemptyset(&signals);
  for (int signal : {SIGTERM, SIGHUP, SIGINT}) {
    struct sigaction present = {};
    if (sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_DFL) sigaddset(&signals, signal);
  }
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  try {
    std::thread([] {
      int signal = 0;
      if (sigwait(&signals, &signal) == 0) remove_temporaries();
      pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
      raise(signal);
    }).detach();
  } catch (const std::system_error&) { // the system cannot start another thread
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  }
#endif
}

/// Lets the allocator keep freed memory: requesting it again takes 3 to 10 % of the time of the command `graph`.
void keep_freed_memory()
{
#ifdef __GLIBC__
  // Sizes in bytes
  constexpr int most_kept = 1 << 26;
  constexpr int largest_kept_block = 1 << 22; // larger blocks are returned when freed
  constexpr int heap_growth = 1 << 22;        // bytes for each request
  mallopt(M_TRIM_THRESHOLD, most_kept);
  mallopt(M_MMAP_THRESHOLD, largest_kept_block);
  mallopt(M_TOP_PAD, heap_growth);
#endif
}

} // namespace

std::vector<std::string> start_program(int argc, char* argv[])
{
  std::signal(SIGXFSZ, SIG_IGN); // exceeding the limit of file size becomes an error of writing
  reserve_standard_streams();
  keep_freed_memory();
  remove_temporaries_at_signals();
  return {argv + 1, argv + argc};
}

fs::path program_file() { return running_file(); }

bool errors_are_on_terminal() { return isatty(STDERR_FILENO); }

double peak_megabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / units_per_megabyte;
}

std::int64_t process_number() { return getpid(); }

bool are_same_name(const fs::path& a, const fs::path& b) { return a == b; }

std::error_code make_new_file(const fs::path& file)
{
  const Descriptor made(open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0666));
  return last_error_if(made < 0);
}

std::error_code write_access(const fs::path& file) { return last_error_if(access(file.c_str(), W_OK) != 0); }

std::error_code synchronize(const fs::path& path)
{
  const Descriptor opened(open(path.c_str(), O_RDONLY));
  return last_error_if(opened >= 0 && fsync(opened) != 0 && errno != EINVAL && errno != ENOTSUP);
}

std::error_code replace(const fs::path& old_path, const fs::path& new_path)
{
  std::error_code error;
  fs::rename(old_path, new_path, error);
  return error;
}

} // namespace CGAL::Shape_correspondence::IO
