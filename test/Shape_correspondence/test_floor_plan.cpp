// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Checks includes against the tables of src/README.md.

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path root = fs::path(SHAPE_CORRESPONDENCE_DATA_DIR).parent_path();
const fs::path public_folder = root / "include/CGAL/Shape_correspondence", private_folder = root / "src";
const std::string public_prefix = "CGAL/Shape_correspondence/";

std::vector<std::string> cells(std::string text, const char* separators)
{
  std::vector<std::string> result;
  boost::algorithm::split(result, text, boost::algorithm::is_any_of(separators));
  for (std::string& cell : result)
    boost::algorithm::trim(cell);
  return result;
}

struct Floor_plan
{
  std::vector<std::string> rooms;
  std::map<std::string, std::set<std::string>> may_include; ///< indexed by room
  std::map<std::string, std::string> headers;               ///< room, by name of a public header without a source
};

Floor_plan read_plan()
{
  Floor_plan plan;
  std::ifstream in(private_folder / "README.md");
  bool is_line_of_room = true;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] != '|' || line[1] == '-') continue;
    const std::vector<std::string> cell = cells(line, "|"); // the first and the last cell are empty
    if (cell[1] == "room") continue;
    if (cell[1] == "public header") {
      is_line_of_room = false;
    } else if (is_line_of_room) {
      plan.rooms.push_back(cell.at(1));
      for (const std::string& room : cells(cell.at(3), ","))
        if (!room.empty()) plan.may_include[cell[1]].insert(room);
    } else {
      plan.headers[cell[1]] = cell.at(2);
    }
  }
  return plan;
}

/// The files of the package, by the names under which they are included.
std::map<std::string, fs::path> package_files()
{
  std::map<std::string, fs::path> files;
  for (const auto& [folder, prefix] : {std::pair(private_folder, std::string()), {public_folder, public_prefix}})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
        files[prefix + entry.path().lexically_relative(folder).generic_string()] = entry.path();
  return files;
}

/// For each file, the files of the package that it includes.
std::map<std::string, std::vector<std::string>> package_includes()
{
  const std::map<std::string, fs::path> files = package_files();
  std::map<std::string, std::vector<std::string>> result;
  for (const auto& [name, path] : files) {
    std::vector<std::string>& included = result[name];
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
      if (line.compare(0, 9, "#include ") != 0) continue;
      const std::string target = line.substr(10, line.find_first_of("\">", 10) - 10);
      if (files.count(target)) included.push_back(target);
    }
  }
  return result;
}

std::string room_of(const std::string& file, const Floor_plan& plan)
{
  if (file.compare(0, public_prefix.size(), public_prefix) != 0) return file.substr(0, file.rfind('/'));
  const std::string name = fs::path(file.substr(public_prefix.size())).replace_extension().generic_string();
  const auto listed = plan.headers.find(name);
  if (listed != plan.headers.end()) return listed->second;
  const std::string source = fs::path(name).filename().string() + ".cpp";
  for (const std::string& room : plan.rooms)
    if (fs::exists(private_folder / room / source)) return room;
  return "";
}

/// Depth-first search along includes. \return a file on a cycle; empty if there is none
std::string file_in_circle(const std::string& file, const std::map<std::string, std::vector<std::string>>& includes,
                           std::map<std::string, int>& state)
{
  enum { NEW, OPEN, DONE };
  if (state[file] != NEW) return state[file] == OPEN ? file : "";
  state[file] = OPEN;
  for (const std::string& included : includes.at(file)) {
    const std::string found = file_in_circle(included, includes, state);
    if (!found.empty()) return found;
  }
  state[file] = DONE;
  return "";
}

} // namespace

TEST_CASE("The plan goes downward: a room may include rooms of the lines above only")
{
  const Floor_plan plan = read_plan();
  REQUIRE(plan.rooms.size() >= 12);
  std::set<std::string> above;
  for (const std::string& room : plan.rooms) {
    INFO(room);
    CHECK(fs::is_directory(private_folder / room));
    if (plan.may_include.count(room))
      for (const std::string& other : plan.may_include.at(room)) {
        INFO(other);
        CHECK(above.count(other));
      }
    above.insert(room);
  }
}

TEST_CASE("Every file has a room")
{
  const Floor_plan plan = read_plan();
  const std::set<std::string> rooms(plan.rooms.begin(), plan.rooms.end());
  for (const auto& [file, path] : package_files()) {
    INFO(file);
    CHECK(rooms.count(room_of(file, plan)));
  }
  for (const auto& [header, room] : plan.headers) {
    INFO(header);
    CHECK(fs::exists(public_folder / (header + ".h")));
  }
}

TEST_CASE("Files include what the plan allows")
{
  const Floor_plan plan = read_plan();
  for (const auto& [file, included] : package_includes())
    for (const std::string& target : included) {
      const std::string from = room_of(file, plan), to = room_of(target, plan);
      if (from == to) continue;
      INFO(file << " (" << from << ") includes " << target << " (" << to << ")");
      CHECK((plan.may_include.count(from) && plan.may_include.at(from).count(to)));
    }
}

TEST_CASE("The core needs no room above it, and is what CMake builds as it")
{
  const Floor_plan plan = read_plan();
  std::ifstream in(root / "CMakeLists.txt");
  std::set<std::string> core;
  for (std::string line; std::getline(in, line);)
    if (const std::string begin = "set(library_rooms "; line.rfind(begin, 0) == 0)
      for (const std::string& room : cells(line.substr(begin.size(), line.find(')') - begin.size()), " "))
        core.insert(room);
  REQUIRE(core.size() == 8);
  for (const std::string& room : core)
    if (plan.may_include.count(room))
      for (const std::string& other : plan.may_include.at(room)) {
        INFO(room << " includes " << other);
        CHECK(core.count(other));
      }
}

TEST_CASE("No files include each other in a circle")
{
  const auto includes = package_includes();
  REQUIRE(includes.size() > 100);
  std::map<std::string, int> state;
  for (const auto& [file, included] : includes)
    CHECK(file_in_circle(file, includes, state) == "");
}

TEST_CASE("Code for single compilers or systems is in the files made for it only")
{
  const std::regex compiler("__attribute__|__builtin_|\\b__int128|\\bssize_t"),
      system("#include <(unistd|windows|fcntl|io|dlfcn|spawn|poll|sys/.*)\\.h>|_WIN32|__linux__|__APPLE__");
  const std::set<std::string> of_compilers{"base/target_clones.h"},
      of_systems{"io/system/posix.cpp",    "io/system/windows.cpp",     "io/system/posix_systems.h",
                 "io/system/Descriptor.h", "io/system/run_program.cpp", "io/read/import_parts.cpp",
                 "import/main.cpp"};
  for (const auto& [file, path] : package_files()) {
    INFO(file);
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
      INFO(line);
      CHECK_FALSE((std::regex_search(line, system) && !of_systems.count(file)));
      CHECK_FALSE((std::regex_search(line, compiler) && !of_compilers.count(file) && !of_systems.count(file)));
    }
  }
}

TEST_CASE("Only messages of the program name its switches; those of the library name options and functions")
{
  const std::regex switch_in_text("\"[^\"]*--[a-z]");
  std::size_t switches_of_program = 0;
  for (const auto& [file, path] : package_files()) {
    const bool is_of_program = file.compare(0, 4, "cli/") == 0;
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
      if (!std::regex_search(line, switch_in_text)) continue;
      INFO(file << ": " << line);
      CHECK(is_of_program);
      switches_of_program += is_of_program;
    }
  }
  CHECK(switches_of_program > 50);
}

TEST_CASE("No constant of a source has the name of one of a header, which it would hide from sources combined with it")
{
  const std::regex definition("(\\w+)(?:\\[\\w*\\])? ?(?:= |\\{)");
  std::map<std::string, std::set<std::string>> of_headers, of_sources; // files by name of a constant
  for (const auto& [file, path] : package_files()) {
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
      if (line.compare(0, 10, "constexpr ") != 0 || line.find(") {") != std::string::npos) continue;
      const std::string code = line.substr(0, line.find("//"));
      for (std::sregex_iterator found(code.begin(), code.end(), definition), end; found != end; ++found)
        (path.extension() == ".h" ? of_headers : of_sources)[(*found)[1]].insert(file);
    }
  }
  REQUIRE(of_headers.count("surface_samples"));
  REQUIRE(of_sources.size() > 100);
  for (const auto& [name, sources] : of_sources) {
    INFO(name << " in " << *sources.begin());
    CHECK_FALSE(of_headers.count(name));
  }
}

TEST_CASE("No type of a private header has the name of a public one, with which it would be ambiguous")
{
  const std::regex definition("(?:struct|class|enum class) (\\w+)(?: final)?(?: : .*)?(?: \\{.*)?");
  std::set<std::string> of_package;
  std::map<std::string, std::string> of_rooms; // files by name of a type
  for (const auto& [file, path] : package_files()) {
    if (path.extension() != ".h") continue;
    const bool is_public = file.compare(0, public_prefix.size(), public_prefix) == 0;
    std::ifstream in(path);
    std::smatch found;
    for (std::string line; std::getline(in, line);) {
      if (!std::regex_match(line, found, definition)) continue;
      if (is_public)
        of_package.insert(found[1]);
      else
        of_rooms.emplace(found[1], file);
    }
  }
  REQUIRE(of_package.count("Part_pair"));
  REQUIRE(of_rooms.count("Piece_pair"));
  for (const auto& [name, file] : of_rooms) {
    INFO(name << " in " << file);
    CHECK_FALSE(of_package.count(name));
  }
}
