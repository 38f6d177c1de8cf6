// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

constexpr std::uintmax_t largest_model = std::uintmax_t(2) << 30; ///< bytes of a file

/// A part as the readers of the formats deliver it: a name and the corners of its triangles, three after three.
struct Model_part
{
  std::string name;
  std::vector<Point> corners;
  Part_appearance appearance = {}; ///< of the triangles, as it is in the file; materials are those of the model
  /// By triangle, the number of its face in the file; empty where faces have no numbers. Those that are left out count.
  std::vector<std::size_t> faces = {};
};

/// Labels of the faces of a model.
struct Face_labels
{
  std::vector<int> of_faces; ///< index of its name for each face
  std::vector<std::string> names = {};
  std::string model = {}; ///< the name of the file that they were written for; empty: not known
};

/// What comments say in files that the program writes: that the objects of the file are the parts, whose names have
/// %XX for special characters, and which direction is up.
std::string mark_of_parts(const Point& up);

/// The upright direction in such a comment; none if it is another one.
std::optional<Point> up_in_mark(std::string_view comment);

/// What a model file holds.
struct Model_content
{
  std::vector<Model_part> parts;
  std::size_t faces_left_out = 0;  ///< those of fewer than three corners
  std::size_t number_of_faces = 0; ///< that `Model_part::faces` number
  std::vector<Surface_material> materials = {};
  std::vector<Texture> textures = {};          ///< those without bytes are files of that name
  bool are_labelled = false;                   ///< the parts are labels of faces, or marked as parts
  std::vector<std::string> without_faces = {}; ///< the names of objects that were left out
  std::vector<std::string> warnings = {};      ///< on what was left out or replaced
  bool materials_are_names = false;            ///< they are defined in libraries
  std::vector<std::string> libraries = {};     ///< files of materials
  std::vector<std::string> warnings_of_looks = {};
  Point up = Point::Zero(); ///< as the file says; zero: it does not
};

/// The readers of the formats. They throw `Invalid_input`, and name the file. Names may be empty, equal, and of any
/// bytes.
/// \param text all of the file \param file its name, for messages
Model_content read_obj_parts(std::string_view text, const std::string& file);
Model_content read_off_part(std::string_view text, const std::string& file);
Model_content read_ply_part(std::string_view text, const std::string& file);
Model_content read_stl_parts(std::string_view text, const std::string& file);

/// The same for glTF and GLB; the document may name files with its buffers. Nodes are parts.
Model_content read_gltf_parts(std::string_view text, const std::string& file, const Reading_options& options = {});

/// The same for a robot as URDF describes it, with all joints at 0; its links are parts. \param folder of
/// all meshes; empty: that of the file \param read reads a mesh file
using Mesh_reader = std::function<Model_content(const std::string& path)>;
Model_content read_urdf_parts(const std::string& text, const std::string& file, const std::string& folder,
                              const Reading_options& options, const Mesh_reader& read);

/// The same for the formats that assimp knows, by a program of its own: a file that breaks it is an error.
Model_content import_parts(const std::string& file, const Reading_options& options);

/// The labels in a list for the faces of a model, in their order: a line with a whole number for each face, or with a
/// name for each; or lines with a name, each with lines of the numbers of its faces after it, from 1 on. Blank lines
/// and comments, which begin with #, are none; `# part NUMBER NAME` names a number. \param name of the list, for
/// messages
/// \throw Invalid_input
Face_labels read_face_labels(std::string_view text, const std::string& name, std::size_t number_of_faces);

/// Makes parts of a model anew, one for each label of its faces; if it is one label only, or they are more than parts
/// can be, the parts stay.
void divide_by_labels(const Face_labels& labels, Model_content& content);

/// Triangles of a model beyond one a byte of its files, as strips have at most. Nodes that use the same mesh take
/// hardly any bytes, but their triangles take memory and time as all others.
constexpr std::uint64_t most_repeated_triangles = 1'000'000;

inline bool are_repeated_too_often(std::uint64_t triangles, std::uint64_t bytes)
{
  return triangles > most_repeated_triangles && triangles - most_repeated_triangles > bytes;
}

constexpr const char* repeated_too_often =
    "its nodes use the same meshes again and again, which makes more than a million triangles beyond what is in the "
    "file; simplify these meshes, or leave out some of the nodes";

/// The bytes of a file that a model names, or why there are none, as the end of a sentence.
struct Named_file
{
  std::string bytes, fault;
};

/// Reads the files that a model names: from its folder or, where they are not there by the path that it gives, beside
/// it.
struct Named_files
{
  const std::string& model;
  const Reading_options& options;
  std::uintmax_t largest; ///< bytes of a file
  std::uintmax_t& rest;   ///< bytes of files that may be read for the model; what is read is taken off

  Named_file read(const std::string& given) const;
};

/// Whether there is a reader for files of a name like this, by its extension.
bool is_model_file(const std::string& path);

/// The triangles of a polygon, concave ones included, as the numbers of its corners, three a triangle; none if it has
/// fewer than 3 corners.
std::vector<std::size_t> triangles_of_polygon(const std::vector<Point>& polygon);

/// The indexed mesh of triangles given by their corners: corners at the same place become one vertex, vertices are
/// numbered as they first appear, triangles with two corners at the same place are left out.
/// \param kept where not null, gets the numbers of the triangles that are left
/// \pre all coordinates are finite
Part_mesh weld(const std::vector<Point>& corners, std::vector<std::size_t>* kept = nullptr);

/// Some parts of a shape as one mesh, with its appearance. \param appearance may lack parts
std::pair<Part_mesh, Part_appearance> joined_parts(const Segmented_shape& shape, const Shape_appearance& appearance,
                                                   const std::vector<std::size_t>& parts);

/// The appearance of some triangles of a part.
Part_appearance looks_of(const Part_appearance& all, const std::vector<std::size_t>& triangles);

/// Moves the materials and textures of a file to the end of those of others, and renumbers those of its parts.
void append_looks(Model_content& from, Model_content& to);

/// Appends the appearance of more triangles; attributes that only one side has are filled with defaults.
void add_looks(const Part_appearance& more, std::size_t more_triangles, std::size_t triangles, Part_appearance& all);

} // namespace CGAL::Shape_correspondence::IO
