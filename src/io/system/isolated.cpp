// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/isolated.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <new>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#if defined(__SANITIZE_ADDRESS__)
#define SHAPE_CORRESPONDENCE_SHADOW_MEMORY
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SHAPE_CORRESPONDENCE_SHADOW_MEMORY
#endif
#endif

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr rlim_t memory_limit = rlim_t(2) << 30; // bytes that the work may take
constexpr rlim_t time_limit = 60;                // seconds of processor time

// First byte of what the process sends
constexpr char is_result = 'r', is_refusal = 'e', is_failure = 'f';

/// Exit status that means that memory ran out.
constexpr int out_of_memory = 3;

template <typename Resource>
void set_limit(Resource resource, rlim_t limit)
{
  rlimit own;
  getrlimit(resource, &own);
  own.rlim_cur = std::min(limit, own.rlim_max);
  setrlimit(resource, &own);
}

/// Bytes of data that this process has already.
rlim_t data_size()
{
  std::ifstream in("/proc/self/statm");
  rlim_t pages[6] = {};
  for (rlim_t& number : pages)
    in >> number;
  return pages[5] * rlim_t(sysconf(_SC_PAGESIZE));
}

void set_limits()
{
#ifndef SHAPE_CORRESPONDENCE_SHADOW_MEMORY
  set_limit(RLIMIT_DATA, data_size() + memory_limit);
#endif
  set_limit(RLIMIT_CPU, time_limit);
  set_limit(RLIMIT_CORE, 0);
}

/// What a library says while it dies is of no use to anybody.
void silence()
{
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

bool send(int pipe, const std::string& bytes)
{
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t n = ::write(pipe, bytes.data() + sent, bytes.size() - sent);
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) sent += std::size_t(n);
  }
  return true;
}

std::string received(int pipe)
{
  std::string result;
  std::string buffer(std::size_t(1) << 16, '\0');
  for (;;) {
    const ssize_t n = ::read(pipe, buffer.data(), buffer.size());
    if (n == 0 || (n < 0 && errno != EINTR)) return result;
    if (n > 0) result.append(buffer, 0, std::size_t(n));
  }
}

/// The other process from its beginning to its end.
[[noreturn]] void run_child(int pipe, const std::function<std::string()>& work)
{
  int status = 0;
  try {
    silence();
    set_limits();
    std::string answer;
    try {
      answer = is_result + work();
    } catch (const Invalid_input& error) {
      answer = is_refusal + std::string(error.what());
    } catch (const std::bad_alloc&) {
      status = out_of_memory;
    } catch (const std::exception& error) {
      answer = is_failure + std::string(error.what());
    }
    if (!send(pipe, answer)) status = 1;
  } catch (...) {
    status = out_of_memory;
  }
  _exit(status); // of what this process has taken over, nothing is to be done twice
}

/// How a process ended that sent nothing of use.
std::string ending(int status)
{
  if (WIFEXITED(status) && WEXITSTATUS(status) == out_of_memory) return "takes more than 2 GB of memory";
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return "takes more than 60 seconds of processor time";
  if (WIFSIGNALED(status)) return std::string("makes its reader crash (") + strsignal(WTERMSIG(status)) + ")";
  return "makes its reader crash";
}

/// Starts the process. \return its id and the end of the pipe that it writes to
std::pair<pid_t, int> start(const std::string& file, const std::function<std::string()>& work)
{
  // The write end must be in no other process, which would keep it open
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  int ends[2];
  if (pipe(ends) != 0) throw Invalid_input(file + ": no process can be started to read it: " + std::strerror(errno));
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    run_child(ends[1], work);
  }
  const int reason = errno;
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    throw Invalid_input(file + ": no process can be started to read it: " + std::strerror(reason));
  }
  return {child, ends[0]};
}

} // namespace

std::string run_isolated(const std::string& file, const std::function<std::string()>& work)
{
  const auto [child, pipe] = start(file, work);
  std::string answer = received(pipe);
  close(pipe);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (status != 0 || answer.empty())
    throw Invalid_input(file + ": it " + ending(status) + "; it is damaged, or too large");
  const std::string content = answer.substr(1);
  if (answer[0] == is_refusal) throw Invalid_input(content);
  if (answer[0] == is_failure) throw Invalid_input(file + ": it cannot be read (" + content + ")");
  return content;
}

} // namespace CGAL::Shape_correspondence::IO
