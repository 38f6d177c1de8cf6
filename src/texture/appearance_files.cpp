// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/atomic_file.h"
#include "io/system/colours.h"
#include "io/system/input_file.h"
#include "io/system/quoting.h"
#include "io/write/ply_file.h"
#include "texture/dressed_meshes.h"
#include "texture/image_file.h"
#include "texture/vertex_colours.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <Eigen/Geometry>

#include <cmath>
#include <filesystem>
#include <ostream>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double edges_across = 100; // of a coloured mesh, over the diagonal of the shape

void write_bytes(const std::string& path, const std::string& bytes)
{
  write_atomically(path, [&](std::ostream& out) { out << bytes; });
}

/// One object per part; every corner has texture coordinates of its own.
void write_textured_obj(std::ostream& out, const Segmented_shape& shape, const Shape_appearance& appearance,
                        const std::string& library)
{
  const auto precision = out.precision(17);
  out << "mtllib " << library << '\n';
  int first = 1, corner = 1;
  for (std::size_t i = 0; i < shape.parts().size(); ++i) {
    const Part_mesh& mesh = shape.parts()[i].mesh;
    out << "o " << quote_obj(shape.parts()[i].name) << '\n';
    for (const auto& p : mesh.points.colwise())
      out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const Eigen::Vector2f& at : appearance.parts[i].coordinates)
      out << "vt " << at.x() << ' ' << 1 - at.y() << '\n';
    out << "usemtl transferred\n";
    for (const auto& triangle : mesh.triangles.colwise()) {
      out << 'f';
      for (int vertex : triangle)
        out << ' ' << vertex + first << '/' << corner++;
      out << '\n';
    }
    first += static_cast<int>(mesh.points.cols());
  }
  out.precision(precision);
}

std::string material_library(const std::string& texture)
{
  return "newmtl transferred\nKd 1 1 1\nmap_Kd " + texture + '\n';
}

void write_coloured_ply(std::ostream& out, const Segmented_shape& shape, const Transferred_appearance& transferred,
                        const std::vector<std::string>& labels)
{
  Eigen::AlignedBox3d box;
  for (const Shape_part& part : shape.parts())
    box.extend(Eigen::AlignedBox3d(part.mesh.points.rowwise().minCoeff(), part.mesh.points.rowwise().maxCoeff()));
  std::vector<Ply_part> parts;
  for (std::size_t i = 0; i < shape.parts().size(); ++i) {
    internal::Coloured_mesh coloured = internal::coloured_mesh(shape.parts()[i].mesh, transferred.appearance, i, grey(),
                                                               box.diagonal().norm() / edges_across);
    Ply_part part{shape.parts()[i].name, std::move(coloured.mesh)};
    for (Eigen::Index v = 0; v < part.mesh.points.cols(); ++v)
      for (double channel : srgb_colour(coloured.colours.col(v)))
        part.colours.push_back(static_cast<std::uint8_t>(std::lround(255 * channel)));
    for (int given : coloured.triangle_given)
      if (!labels.empty()) part.labels.push_back(transferred.parts[i].labels[std::size_t(given)]);
    parts.push_back(std::move(part));
  }
  write_ply(out, parts, labels);
}

} // namespace

void decode_textures(Shape_appearance& appearance, std::vector<std::string>& warnings)
{
  Image_budget budget;
  for (std::size_t i = 0; i < appearance.textures.size(); ++i) {
    Texture& texture = appearance.textures[i];
    if (texture.bytes.empty() || !texture.image.empty()) continue;
    try {
      texture.image = decoded_image(texture.bytes, budget);
    } catch (const Invalid_input& error) {
      warnings.push_back("The texture '" + texture.name + "' was left out: it " + error.what() + ".");
      for (Surface_material& material : appearance.materials)
        if (material.texture == int(i)) material.texture = -1;
    }
  }
}

void write_transferred_shape(const std::string& path, const Segmented_shape& shape,
                             const Transferred_appearance& transferred, const std::vector<std::string>& labels)
{
  const std::string extension = lower_extension(path);
  if (extension == ".ply") {
    write_atomically(path, [&](std::ostream& out) { write_coloured_ply(out, shape, transferred, labels); });
    return;
  }
  const std::string png = png_of(transferred.appearance.textures[0].image);
  if (extension == ".glb") {
    Shape_appearance encoded = transferred.appearance;
    encoded.textures[0].bytes = png;
    write_atomically(path, [&](std::ostream& out) { write_segmented_shape_glb(out, shape, encoded); });
  } else if (extension == ".obj") {
    std::filesystem::path library(path), texture(path);
    library.replace_extension(".mtl");
    texture.replace_extension(".png");
    write_bytes(texture.string(), png);
    write_bytes(library.string(), material_library(texture.filename().string()));
    write_atomically(path, [&](std::ostream& out) {
      write_textured_obj(out, shape, transferred.appearance, library.filename().string());
    });
  } else
    throw Invalid_input(path + ": a shape with textures is written as .glb, .obj or .ply");
}

void write_segmented_shape_glb(std::ostream& out, const Segmented_shape& shape, const Shape_appearance& appearance)
{
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); // glTF has y up
  if (shape.up() != Point::UnitY())
    turn = Eigen::Quaterniond::FromTwoVectors(shape.up(), Point::UnitY()).toRotationMatrix();
  Glb_file glb;
  Glb_materials materials(glb, appearance);
  std::vector<int> nodes;
  for (std::size_t part = 0; part < shape.parts().size(); ++part) {
    const auto& [name, mesh] = shape.parts()[part];
    nodes.push_back(
        glb.add_node(name, dressed(shaded(turn * mesh.points, mesh.triangles), materials.of_part(part), materials)));
  }
  glb.write(out, {{shape.name(), {glb.add_node(shape.name(), nodes, Point::Zero())}}});
}

void write_correspondence_glb(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                              const Structural_graph& target, const Segmented_shape* source_shape,
                              const Segmented_shape* target_shape, const Shape_appearance& source_appearance,
                              const Shape_appearance& target_appearance)
{
  write_correspondence_glb(out, correspondence, source, target, source_shape, target_shape,
                           dressed_scenes({{source_shape, &source_appearance}, {target_shape, &target_appearance}}));
}

void write_structural_graph_glb(std::ostream& out, const Structural_graph& graph, const Segmented_shape* shape,
                                const Shape_appearance& appearance)
{
  write_structural_graph_glb(out, graph, shape, dressed_scenes({{shape, &appearance}}));
}

} // namespace CGAL::Shape_correspondence::IO
