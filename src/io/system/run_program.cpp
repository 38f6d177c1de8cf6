// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/run_program.h"
#include "io/system/input_file.h"
#include "io/system/operating_system.h"
#include "io/system/posix_systems.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace CGAL::Shape_correspondence::IO {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

[[noreturn]] void fail_to_start(const std::string& program, int reason)
{
  throw Invalid_input("the program " + program + " cannot be started (" + std::strerror(reason) + "); " +
                      remedy::install_again);
}

/// Starts a program by `posix_spawn()`, which unlike fork() is safe when other threads hold locks.
pid_t start(const std::string& program, const std::vector<std::string>& arguments, int output)
{
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  close_other_files(actions);
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments)
    argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawnattr_t attributes; // lets the child receive the signals that this process blocks
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, short(spawn_flags | POSIX_SPAWN_SETSIGMASK));
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), &actions, &attributes, argv.data(), environment());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail_to_start(program, error);
  return child;
}

/// Reads until all writers have closed the pipe, or until the time `end`. \return whether it was closed by then
bool read_all(int pipe, Clock::time_point end, std::string& bytes)
{
  std::string buffer(std::size_t(1) << 16, '\0');
  for (;;) {
    const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd waited{pipe, POLLIN, 0};
    const int ready = rest > 0 ? poll(&waited, 1, int(rest)) : 0;
    if (ready == 0) return false;
    if (ready < 0) continue; // interrupted by a signal
    const ssize_t n = ::read(pipe, buffer.data(), buffer.size());
    if (n == 0 || (n < 0 && errno != EINTR)) return true;
    if (n > 0) bytes.append(buffer, 0, std::size_t(n));
  }
}

/// The file from which an address of this process was loaded.
fs::path file_of_code(const void* address)
{
  std::error_code error;
  Dl_info info{};
  return dladdr(address, &info) != 0 && info.dli_fname ? fs::canonical(info.dli_fname, error) : fs::path();
}

} // namespace

Program_run run_program(const std::string& program, const std::vector<std::string>& arguments,
                        std::chrono::milliseconds limit)
{
  const Clock::time_point end = Clock::now() + limit;
  int ends[2];
  if (make_pipe(ends) != 0) fail_to_start(program, errno);
  const Descriptor from(ends[0]);
  Program_run result;
  pid_t child = 0;
  {
    const Descriptor to(ends[1]); // closed here, so that reading ends with the program
    child = start(program, arguments, to);
  }
  try {
    result.took_too_long = !read_all(from, end, result.output);
  } catch (...) { // such as lack of memory
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    throw;
  }
  if (result.took_too_long) kill(child, SIGKILL);
  while (waitpid(child, &result.status, 0) < 0 && errno == EINTR) {
  }
  return result;
}

std::string own_program(const std::string& name, const char* variable)
{
  if (const char* const given = std::getenv(variable)) return given;
  const std::string beside[] = {"", SHAPE_CORRESPONDENCE_LIBEXEC_FROM_BIN, SHAPE_CORRESPONDENCE_LIBEXEC_FROM_LIB};
  std::error_code error;
  const auto is_there = [&](const fs::path& file) { return !file.empty() && fs::is_regular_file(file, error); };
  for (const fs::path& code : {file_of_code(reinterpret_cast<const void*>(&own_program)), program_file()})
    for (const std::string& place : beside)
      if (const fs::path file = code.parent_path() / place / name; !code.empty() && is_there(file))
        return file.string();
  for (const fs::path folder : {SHAPE_CORRESPONDENCE_LIBEXEC, SHAPE_CORRESPONDENCE_BUILT})
    if (is_there(folder / name)) return (folder / name).string();
  throw Invalid_input(
      "the program " + name +
      " is not installed (it is looked for in " SHAPE_CORRESPONDENCE_LIBEXEC
      " and beside the program); install the package anew, or say where it is by the environment variable " +
      variable);
}

} // namespace CGAL::Shape_correspondence::IO
