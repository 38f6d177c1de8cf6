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

constexpr std::uintmax_t largest_model = std::uintmax_t(2) << 30; ///< limit for the size of a file, in bytes

/// A part as delivered by the readers of the formats: a name and the corners of its triangles, three for each.
struct Model_part
{
  std::string name;
  std::vector<Point> corners;
  /// Appearance of the triangles as in the file; materials are indices into those of the model.
  Part_appearance appearance = {};
  /// For each triangle, the index of its face in the file, counting dropped faces; empty if faces have no indices.
  std::vector<std::size_t> faces = {};
  /// Indexed by corner: the index of its vertex in the file; empty if vertices have no indices.
  std::vector<int> vertices = {};
};

/// Labels of the faces of a model.
struct Face_labels
{
  std::vector<int> of_faces; ///< for each face, the index of its label in `names`
  std::vector<std::string> names = {};
  std::string model = {}; ///< name of the file whose faces are labelled; empty: unknown
};

/// The comment in files written by the program, which says that the objects of the file are the parts, with %XX for
/// special characters in names, and which direction is up.
std::string mark_of_parts(const Point& up);

/// The upright direction in a comment by `mark_of_parts()`; none for other comments.
std::optional<Point> up_in_mark(std::string_view comment);

struct Model_content
{
  std::vector<Model_part> parts;
  std::size_t faces_left_out = 0;     ///< number of faces with fewer than three corners
  std::size_t number_of_faces = 0;    ///< number of faces that `Model_part::faces` refers to
  std::size_t number_of_vertices = 0; ///< number of vertices that `Model_part::vertices` refers to
  std::vector<Surface_material> materials = {};
  std::vector<Texture> textures = {};          ///< textures without bytes are files of that name
  bool are_labelled = false;                   ///< whether labels of faces, or this program's mark, define the parts
  std::vector<std::string> without_faces = {}; ///< names of objects that were left out
  std::vector<std::string> warnings = {};      ///< about what was left out or replaced
  bool materials_are_names = false;            ///< whether `materials` have only names, and libraries define them
  std::vector<std::string> libraries = {};     ///< files that define materials
  std::vector<std::string> appearance_warnings = {};
  Point up = Point::Zero(); ///< the up direction that the file gives; zero: none
};

/// Readers of the formats. They throw `Invalid_input` naming the file. Part names may be empty, equal, and of any
/// bytes.
/// \param text content of the file \param file name of the file, for messages
Model_content read_obj_parts(std::string_view text, const std::string& file);
Model_content read_off_part(std::string_view text, const std::string& file);
Model_content read_ply_part(std::string_view text, const std::string& file);
Model_content read_stl_parts(std::string_view text, const std::string& file);

/// Reads glTF and GLB, including files with buffers named by the document. Nodes become parts.
Model_content read_gltf_parts(std::string_view text, const std::string& file, const Reading_options& options = {});

using Mesh_reader = std::function<Model_content(const std::string& path)>;
/// Reads a robot described in URDF with all joints at 0; links become parts. \param folder folder of all meshes; empty:
/// that of `file` \param read reads a mesh file
Model_content read_urdf_parts(const std::string& text, const std::string& file, const std::string& folder,
                              const Reading_options& options, const Mesh_reader& read);

/// Reads the formats that assimp knows in a separate program, so that a file which crashes assimp is an error.
Model_content import_parts(const std::string& file, const Reading_options& options);

/// Reads a list of labels for the faces of a model, in their order: one line for each face with an integer, or with a
/// name; or for each label a line with its name, followed by lines with the numbers of its faces, from 1 on. Blank
/// lines and comments, which start with #, are skipped; `# part NUMBER NAME` gives a number a name.
/// \param name name of the list, for messages
/// \throw Invalid_input
Face_labels read_face_labels(std::string_view text, const std::string& name, std::size_t number_of_faces);

/// Divides a model into one part for each label of its faces, unless there is one label, or more than `most_parts`.
void divide_by_labels(const Face_labels& labels, Model_content& content);

/// Limit for the triangles of a model beyond one for each byte of its files. Meshes have at most one for each byte (in
/// strips), but nodes that repeat a mesh take few bytes, and as much memory and time as separate meshes.
constexpr std::uint64_t most_repeated_triangles = 1'000'000;

inline bool are_repeated_too_often(std::uint64_t triangles, std::uint64_t bytes)
{
  return triangles > most_repeated_triangles && triangles - most_repeated_triangles > bytes;
}

constexpr const char* repeated_too_often =
    "its nodes use the same meshes again and again, which makes more than a million triangles beyond what is in the "
    "file; simplify these meshes, or leave out some of the nodes";

/// The bytes of a file named by a model, or the reason why there are none, as the end of a sentence.
struct Named_file
{
  std::string bytes, fault;
};

/// Reads files named by a model: from the given path within its folder, or else next to the model.
struct Named_files
{
  const std::string& model;
  const Reading_options& options;
  std::uintmax_t largest; ///< limit for the size of a file, in bytes
  std::uintmax_t& rest;   ///< total size of files that may still be read for the model, in bytes

  Named_file read(const std::string& given) const;
};

/// Whether there is a reader for files with this extension.
bool is_model_file(const std::string& path);

/// Triangulates a polygon, convex or not. \return corner indices, three for each triangle; empty for under 3 corners
std::vector<std::size_t> triangles_of_polygon(const std::vector<Point>& polygon);

/// The indexed mesh of triangles given by their corners: corners at the same position become one vertex, vertices are
/// numbered in the order of appearance, and triangles with two corners at the same position are dropped.
/// \param kept receives the indices of the remaining triangles; may be null
/// \pre all coordinates are finite
Part_mesh weld(const std::vector<Point>& corners, std::vector<std::size_t>* kept = nullptr);

/// Joins some parts of a shape to one mesh, with its appearance. \param appearance may have fewer parts
std::pair<Part_mesh, Part_appearance> joined_parts(const Segmented_shape& shape, const Shape_appearance& appearance,
                                                   const std::vector<std::size_t>& parts);

/// The appearance of a subset of the triangles of a part.
Part_appearance appearance_of(const Part_appearance& all, const std::vector<std::size_t>& triangles);

/// Appends the materials and textures of `from` to those of `to`; updates their indices in the parts of `from`.
void append_appearance(Model_content& from, Model_content& to);

/// Appends the appearance of `more_triangles` to that of `triangles`; defaults complete attributes that only one has.
void add_appearance(const Part_appearance& more, std::size_t more_triangles, std::size_t triangles,
                    Part_appearance& all);

struct Tree_node
{
  int parent; ///< -1: none
  std::string name;
};

/// Names parts with default names, such as `Object_4`, after the nearest ancestor node with a better name, unless it
/// contains all parts; else after their mesh.
/// \param tree the nodes, each after its parent \param node_of_part the node of each part
/// \param meshes names of the parts' meshes
void name_parts_by_tree(const std::vector<Tree_node>& tree, const std::vector<int>& node_of_part,
                        const std::vector<std::string>& meshes, std::vector<Model_part>& parts);

} // namespace CGAL::Shape_correspondence::IO
