// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/atomic_file.h"
#include "io/system/operating_system.h"
#include "io/system/utf8_paths.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>

#ifndef NOMINMAX
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <psapi.h>
#include <shellapi.h>

namespace CGAL::Shape_correspondence::IO {
namespace {

namespace fs = std::filesystem;

std::error_code last_error_if(BOOL failed)
{
  return failed ? std::error_code(int(GetLastError()), std::system_category()) : std::error_code();
}

/// A handle, closed at the end of its scope.
class Handle
{
public:
  explicit Handle(HANDLE handle) : handle_(handle) {}
  ~Handle()
  {
    if (is_open()) CloseHandle(handle_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  operator HANDLE() const { return handle_; }
  bool is_open() const { return handle_ && handle_ != INVALID_HANDLE_VALUE; }

private:
  HANDLE handle_;
};

HANDLE open_to_write(const fs::path& file, DWORD creation, DWORD attributes)
{
  return CreateFileW(file.c_str(), GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ, nullptr, creation, attributes,
                     nullptr);
}

/// Sets the encoding of the console to UTF-8 until the program ends.
void write_utf8()
{
  static const UINT before = GetConsoleOutputCP();
  if (before != 0 && SetConsoleOutputCP(CP_UTF8)) std::atexit([] { SetConsoleOutputCP(before); });
}

std::string utf8_of(const wchar_t* text)
{
  const int size = WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
  std::string result(std::size_t(size), '\0');
  WideCharToMultiByte(CP_UTF8, 0, text, -1, result.data(), size, nullptr, nullptr);
  result.pop_back(); // removes the terminating zero
  return result;
}

/// Called when the program is asked to end, for example by Ctrl+C; the program ends after it.
BOOL WINAPI remove_temporaries_at_end(DWORD)
{
  remove_temporaries();
  return FALSE;
}

} // namespace

std::vector<std::string> start_program(int, char*[])
{
  for (int stream : {0, 1, 2})
    _setmode(stream, _O_BINARY); // no conversion of line ends
  write_utf8();
  set_utf8_paths();
  SetConsoleCtrlHandler(remove_temporaries_at_end, TRUE);
  int count = 0;
  const std::unique_ptr<LPWSTR, decltype(&LocalFree)> words(CommandLineToArgvW(GetCommandLineW(), &count), &LocalFree);
  std::vector<std::string> arguments;
  for (int i = 1; i < count; ++i)
    arguments.push_back(utf8_of(words.get()[i]));
  return arguments;
}

fs::path program_file()
{
  std::wstring name(1 << 15, L'\0'); // the maximum length of a path
  name.resize(GetModuleFileNameW(nullptr, name.data(), DWORD(name.size())));
  return name;
}

bool errors_are_on_terminal()
{
  const HANDLE console = GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  return GetConsoleMode(console, &mode) && SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

double peak_megabytes()
{
  constexpr double megabyte = 1 << 20;
  PROCESS_MEMORY_COUNTERS counters{};
  K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters);
  return double(counters.PeakWorkingSetSize) / megabyte;
}

std::int64_t process_number() { return GetCurrentProcessId(); }

bool are_same_name(const fs::path& a, const fs::path& b)
{
  return CompareStringOrdinal(a.c_str(), -1, b.c_str(), -1, TRUE) == CSTR_EQUAL;
}

std::error_code make_new_file(const fs::path& file)
{
  const Handle made(open_to_write(file, CREATE_NEW, FILE_ATTRIBUTE_NORMAL));
  return last_error_if(!made.is_open());
}

std::error_code write_access(const fs::path& file)
{
  constexpr int writing = 2;
  return _waccess(file.c_str(), writing) == 0 ? std::error_code() : std::error_code(errno, std::generic_category());
}

std::error_code synchronize(const fs::path& path)
{
  std::error_code error;
  if (fs::is_directory(path, error)) return {};
  const Handle file(open_to_write(path, OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL));
  return last_error_if(!file.is_open() || !FlushFileBuffers(file));
}

std::error_code replace(const fs::path& old_path, const fs::path& new_path)
{
  // Number of attempts to replace a file, which fails while another process, such as a virus scanner, has it open
  constexpr int attempts = 50;
  constexpr DWORD pause = 20; // pause in milliseconds
  std::error_code error;
  if (fs::is_directory(new_path, error)) fs::remove(new_path, error);
  for (int i = 0; i < attempts; ++i) {
    error = last_error_if(
        !MoveFileExW(old_path.c_str(), new_path.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH));
    if (error.value() != ERROR_ACCESS_DENIED && error.value() != ERROR_SHARING_VIOLATION) return error;
    Sleep(pause);
  }
  return error;
}

} // namespace CGAL::Shape_correspondence::IO
