// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_CORRESPONDENCE_TEST_FILE_READERS_H
#define SHAPE_CORRESPONDENCE_TEST_FILE_READERS_H

#include "texture/image_file.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/parts_json.h>
#include <CGAL/Shape_correspondence/IO/read_features.h>
#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/Role_model.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

/// Readers of files other than models and graphs, called with the bytes of the file.
namespace file_readers {

namespace IO = CGAL::Shape_correspondence::IO;

/// A file with given content, removed at the end of its scope.
class File
{
public:
  explicit File(const std::string& bytes)
      : path_(std::filesystem::temp_directory_path() / ("read_" + std::to_string(getpid())))
  {
    if (!(std::ofstream(path_, std::ios::binary) << bytes).flush()) std::abort();
  }
  ~File() { std::filesystem::remove(path_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  std::string path() const { return path_.string(); }

private:
  std::filesystem::path path_;
};

inline void labels(const std::string& bytes) { IO::read_part_labels(File(bytes).path()); }

inline void result(const std::string& bytes) { IO::read_correspondence_json(File(bytes).path()); }

/// Reads a list of pieces for a shape of two pieces, `seat` and `leg`.
inline void pieces(const std::string& bytes)
{
  static const CGAL::Shape_correspondence::Segmented_shape shape = [] {
    CGAL::Shape_correspondence::Part_mesh mesh{CGAL::Shape_correspondence::Points(3, 4), Eigen::Matrix3Xi(3, 4)};
    mesh.points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
    mesh.triangles << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3;
    CGAL::Shape_correspondence::Segmented_shape pieces("stool");
    pieces.add_part("seat", mesh);
    mesh.points.row(1).array() -= 2;
    pieces.add_part("leg", mesh);
    return pieces;
  }();
  IO::split_parts_by_json(shape, File(bytes).path());
}

/// Reads role models without their digest, which would detect any damage.
inline void roles(const std::string& bytes)
{
  std::istringstream in(bytes);
  CGAL::Shape_correspondence::Role_model::read(in, "input");
}

inline void features(const std::string& bytes) { IO::read_features(File(bytes).path()); }

inline void image(const std::string& bytes)
{
  IO::Image_budget budget;
  IO::decoded_image(bytes, budget);
}

} // namespace file_readers

#endif // SHAPE_CORRESPONDENCE_TEST_FILE_READERS_H
