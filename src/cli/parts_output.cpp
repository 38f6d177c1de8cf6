// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/parts_output.h"
#include "cli/run.h"
#include "cli/text.h"
#include "io/read/model_parts.h"
#include "io/system/atomic_file.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <filesystem>
#include <locale>
#include <ostream>
#include <set>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// A file for each part, named like it, as far as systems allow such names and they differ.
void write_part_files(const std::string& folder, const Segmented_shape& shape)
{
  std::set<std::string> taken; // in small letters, which are the same to some systems
  const auto take = [&](const std::string& name) {
    return taken.insert(boost::algorithm::to_lower_copy(name, std::locale::classic())).second;
  };
  for (const Shape_part& part : shape.parts()) {
    std::string name = IO::file_name(part.name);
    for (int number = 2; !take(name); ++number)
      name = IO::file_name(part.name) + '#' + std::to_string(number);
    Segmented_shape one(part.name, shape.up());
    one.add_part(part.name, part.mesh);
    IO::write_atomically(folder + '/' + name + ".obj",
                         [&](std::ostream& out) { IO::write_segmented_shape_obj(out, one); });
  }
}

/// The number of the part of each triangle of an object: of the triangle that is the same, or nearest.
std::vector<int> parts_of_triangles(const Read_model& model, std::size_t object)
{
  std::set<std::size_t> numbers;
  for (const Model_piece& piece : model.split.pieces)
    if (piece.object == object && piece.part != no_part) numbers.insert(piece.part);
  Shape_appearance looks;
  for (std::size_t part = 0; part < model.split.shape.parts().size(); ++part) {
    const auto triangles = std::size_t(model.split.shape.parts()[part].mesh.triangles.cols());
    looks.parts.push_back({std::vector<int>(triangles, int(part)), {}, {}});
  }
  const auto [mesh, labels] = IO::joined_parts(model.split.shape, looks, {numbers.begin(), numbers.end()});
  return appearance_on(mesh, labels, model.objects.parts()[object].mesh).materials;
}

/// A line for each face of the file, then comments with its name and those of the parts. A face without area has the
/// part of the face before it.
void write_face_labels(std::ostream& out, const std::string& path, const Read_model& model)
{
  constexpr int unknown = -1;
  std::vector<int> labels(model.number_of_faces, unknown);
  for (std::size_t object = 0; object < model.faces.size(); ++object) {
    const std::vector<int> parts = parts_of_triangles(model, object);
    for (std::size_t t = 0; t < parts.size(); ++t)
      labels[model.faces[object][t]] = parts[t];
  }
  int last = 0;
  for (int label : labels)
    out << (last = label == unknown ? last : label) << '\n';
  out << "# faces of " << IO::quote_ply(std::filesystem::path(path).filename().string()) << '\n';
  const std::vector<Shape_part>& parts = model.split.shape.parts();
  for (std::size_t part = 0; part < parts.size(); ++part)
    out << "# part " << part << ' ' << IO::quote_ply(parts[part].name) << '\n';
}

/// With its materials.
void write_glb(std::ostream& out, const std::string& path, const Common_options& options, Read_model& model)
{
  Loaded_shape shape;
  shape.path = path;
  shape.model = model.split.shape;
  shape.split = model.split;
  shape.reading = options.reading_options();
  read_appearance(shape);
  append(model.warnings, shape.appearance.warnings);
  IO::write_segmented_shape_glb(out, model.split.shape, shape.appearance);
}

} // namespace

void write_parts(const Parts_output& output, const std::string& path, const Common_options& options, Read_model& model)
{
  const Segmented_shape& shape = model.split.shape;
  if (!output.seg.empty() && model.faces.size() != model.objects.parts().size())
    throw Invalid_input(path + ": labels of faces, " + output.seg +
                        ", are for models in OBJ, OFF, PLY or STL; write the parts as .ply, .obj or .glb");
  write_output(output.seg, [&](std::ostream& out) { write_face_labels(out, path, model); });
  write_output(output.ply, [&](std::ostream& out) { IO::write_segmented_shape_ply(out, shape); });
  write_output(output.obj, [&](std::ostream& out) { IO::write_segmented_shape_obj(out, shape); });
  write_output(output.glb, [&](std::ostream& out) { write_glb(out, path, options, model); });
  if (!output.folder.empty())
    IO::write_folder_atomically(output.folder, [&](const std::string& folder) { write_part_files(folder, shape); });
}

} // namespace CGAL::Shape_correspondence::cli
