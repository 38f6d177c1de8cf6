// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_CORRESPONDENCE_TEST_MODEL_FILES_H
#define SHAPE_CORRESPONDENCE_TEST_MODEL_FILES_H

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace model_files {

namespace fs = std::filesystem;

/// A new folder for a test, removed at the end.
class Temporary_folder
{
public:
  Temporary_folder()
  {
    std::string name = (fs::temp_directory_path() / "shape_correspondence_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Temporary_folder() { fs::remove_all(path_); }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  std::string path(const std::string& name) const { return (path_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const
  {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path(name);
  }

  std::size_t number_of_files() const
  {
    std::size_t n = 0;
    for (const auto& entry : fs::recursive_directory_iterator(path_))
      n += entry.is_regular_file();
    return n;
  }

private:
  fs::path path_;
};

inline std::string text_of(const std::string& file)
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// The vertices of a box in OBJ, OFF or PLY, one in each line. \param keyword start of the lines
inline std::string box_vertices(double x, double y, double z, double dx, double dy, double dz,
                                const std::string& keyword)
{
  std::ostringstream out;
  out.precision(17);
  for (int i = 0; i < 8; ++i)
    out << keyword << x + dx * (i & 1) << ' ' << y + dy * (i >> 1 & 1) << ' ' << z + dz * (i >> 2) << '\n';
  return out.str();
}

/// The six faces of a box as quads. \param first index of its first vertex
inline std::string box_faces(int first, const std::string& keyword)
{
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::ostringstream out;
  for (const auto& face : faces) {
    out << keyword;
    for (int v : face)
      out << v + first << ' ';
    out << '\n';
  }
  return out.str();
}

/// A box as a part of an OBJ file. \param statement such as `o seat` \param index number of parts before it
inline std::string obj_box(const std::string& statement, int index, double x, double y, double z, double dx, double dy,
                           double dz)
{
  return statement + "\n" + box_vertices(x, y, z, dx, dy, dz, "v ") + box_faces(8 * index + 1, "f ");
}

inline std::string obj_table(const std::string& keyword = "o ")
{
  return obj_box(keyword + "top", 0, -0.5, 0.7, -0.5, 1, 0.05, 1) +
         obj_box(keyword + "leg_1", 1, -0.5, 0, -0.5, 0.1, 0.7, 0.1) +
         obj_box(keyword + "leg_2", 2, 0.4, 0, -0.5, 0.1, 0.7, 0.1) +
         obj_box(keyword + "leg_3", 3, -0.5, 0, 0.4, 0.1, 0.7, 0.1) +
         obj_box(keyword + "leg_4", 4, 0.4, 0, 0.4, 0.1, 0.7, 0.1);
}

/// The message of an `Invalid_input` thrown by `call`; empty if it throws none.
template <typename Call>
std::string complaint(Call&& call)
{
  try {
    call();
  } catch (const CGAL::Shape_correspondence::Invalid_input& error) {
    return error.what();
  }
  return "";
}

} // namespace model_files

#endif // SHAPE_CORRESPONDENCE_TEST_MODEL_FILES_H
