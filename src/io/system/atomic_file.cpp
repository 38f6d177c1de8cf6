// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/atomic_file.h"
#include "io/system/input_file.h"
#include "io/system/operating_system.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/algorithm/string/replace.hpp>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <set>
#include <sstream>

namespace CGAL::Shape_correspondence::IO {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& why)
{
  const std::string name = path == "-" ? "standard output" : path;
  throw Invalid_input(name + ": it cannot be written (" + why + "); " + remedy::write_elsewhere);
}

bool is_device(const fs::path& file)
{
  std::error_code error;
  return fs::exists(file, error) && !fs::is_regular_file(file, error) && !fs::is_directory(file, error);
}

std::string parent_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path().string() : "."; }

/// A new name next to `place` in each call; it may exist, left by a killed process.
std::string temporary_name(const fs::path& place)
{
  static std::atomic<unsigned> count{0};
  return place.string() + ".tmp-" + std::to_string(process_number()) + '_' + std::to_string(count++);
}

void fail_if(const std::error_code& error, const std::string& path)
{
  if (error) fail(path, error.message());
}

/// The existing temporary files and folders. Never destroyed, since a signal may arrive while the program ends.
struct Temporaries
{
  std::mutex mutex;
  std::set<std::string> names;
};

Temporaries& temporaries()
{
  static Temporaries* const all = new Temporaries;
  return *all;
}

/// A file or folder under a temporary name, to replace `path`; removed unless it is renamed.
class Temporary
{
public:
  /// \param place path next to which the temporary file or folder is made
  /// \param make creates a file or folder; returns `file_exists` if the name is taken
  Temporary(const std::string& path, const fs::path& place, std::error_code (*make)(const fs::path&)) : path_(path)
  {
    std::error_code error;
    {
      const std::lock_guard<std::mutex> lock(temporaries().mutex);
      do {
        name_ = temporary_name(place);
        error = make(name_);
      } while (error == std::errc::file_exists);
      if (!error) temporaries().names.insert(name_);
    }
    fail_if(error, path);
  }
  ~Temporary()
  {
    std::error_code error;
    if (!renamed_) fs::remove_all(name_, error);
    forget();
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  const std::string& name() const { return name_; }

  void rename_to(const fs::path& place)
  {
    std::error_code error;
    const fs::file_status old = fs::status(place, error);
    if (fs::is_regular_file(old)) fs::permissions(name_, old.permissions(), error);
    fail_if(synchronize(name_), path_);
    fail_if(replace(name_, place), path_);
    renamed_ = true;
    forget();
    fail_if(synchronize(parent_of(place)), path_);
  }

private:
  void forget() const
  {
    const std::lock_guard<std::mutex> lock(temporaries().mutex);
    temporaries().names.erase(name_);
  }

  std::string path_, name_;
  bool renamed_ = false;
};

std::error_code make_new_folder(const fs::path& folder)
{
  std::error_code error;
  const bool is_new = fs::create_directory(folder, error);
  if (!is_new && !error) return std::make_error_code(std::errc::file_exists);
  return error;
}

/// The path without trailing slashes, which would lead into the folder.
fs::path folder_path(const std::string& path)
{
  const fs::path folder(path);
  return folder.has_filename() || !folder.has_relative_path() ? folder : folder.parent_path();
}

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
  if (fs::exists(file, error)) fail_if(write_access(file), path);
}

std::string heading(const std::string& title, const std::string& content)
{
  return title + ' ' + digest(content) + '\n';
}

} // namespace

fs::path written_file(const std::string& path)
{
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  if (!error) return target;
  if (error == std::errc::too_many_symbolic_link_levels) fail(path, error.message());
  fs::path file = path;
  while (fs::is_symlink(file, error))
    file = file.parent_path() / fs::read_symlink(file);
  return file;
}

void check_writable(const std::string& path)
{
  if (path == "-") return;
  const fs::path file = written_file(path);
  check_existing(path, file);
  if (is_device(file)) return;
  Temporary(path, file, make_new_file); // a trial: the file is removed at once
}

void write_atomically(const std::string& path, const std::function<void(std::ostream&)>& write)
{
  if (path == "-") return write_directly(path, std::cout, write);
  const fs::path file = written_file(path);
  check_existing(path, file);
  if (is_device(file)) {
    std::ofstream out(file, std::ios::binary);
    return write_directly(path, out, write);
  }
  Temporary temporary(path, file, make_new_file);
  std::ofstream out(fs::path(temporary.name()), std::ios::binary);
  write_directly(path, out, write);
  out.close();
  if (!out) fail(path, std::strerror(errno));
  temporary.rename_to(file);
}

void write_entry(const std::string& path, const std::function<void(std::ostream&)>& write)
{
  std::error_code error;
  if (is_device(path)) fs::remove(path, error);
  write_atomically(path, write);
}

void check_new_folder(const std::string& path)
{
  const fs::path folder = folder_path(path);
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) fail(path, "it is a file");
  if (fs::exists(folder, error) && !fs::is_empty(folder, error)) fail(path, "the folder is there and not empty");
  Temporary(path, folder, make_new_folder); // a trial: the folder is removed at once
}

void write_folder_atomically(const std::string& path, const std::function<void(const std::string&)>& write)
{
  const fs::path folder = folder_path(path);
  Temporary temporary(path, folder, make_new_folder);
  try {
    write(temporary.name());
  } catch (const Invalid_input& error) { // the message names the file by its final name
    throw Invalid_input(boost::replace_all_copy(std::string(error.what()), temporary.name(), folder.string()));
  }
  temporary.rename_to(folder);
}

void remove_temporaries()
{
  temporaries().mutex.lock(); // never unlocked, so that no other thread makes temporaries while the program ends
  constexpr int attempts = 2; // a second attempt, since other threads may be writing into a folder
  std::error_code error;
  for (int i = 0; i < attempts; ++i)
    for (const std::string& name : temporaries().names)
      fs::remove_all(name, error);
}

void make_folder(const std::string& path, const std::string& use)
{
  std::error_code error, none;
  fs::create_directories(path, error);
  if (!fs::is_directory(path, none))
    throw Invalid_input(path + ": it cannot be used as " + use + " (" + (error ? error.message() : "it is a file") +
                        "); choose another folder");
}

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
