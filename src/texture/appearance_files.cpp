// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "io/system/atomic_file.h"
#include "io/system/colours.h"
#include "io/system/input_file.h"
#include "io/system/quoting.h"
#include "io/write/ply_file.h"
#include "map/Charted_mesh.h"
#include "shape/oriented_box.h"
#include "texture/image_file.h"
#include "texture/textures.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cmath>
#include <filesystem>
#include <ostream>

namespace CGAL::Shape_correspondence::IO {
namespace {

// Limits for the subdivision of a mesh whose texture is written as colours of vertices
constexpr double edges_across = 100; // diagonal of the shape over the longest edge
constexpr std::size_t most_triangles = 200000;

/// Writes one object for each part; every corner has its own texture coordinates.
void write_textured_obj(std::ostream& out, const Segmented_shape& shape, const Shape_appearance& appearance,
                        const std::string& library)
{
  out.precision(17);
  out << "# " << mark_of_parts(shape.up()) << "\nmtllib " << library << '\n';
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
}

/// The mesh with edges subdivided to at most `longest_edge`, as far as this makes no more than `most_triangles`.
Part_mesh divided(const Part_mesh& mesh, double longest_edge)
{
  internal::Subdivision fine(mesh.points, mesh.triangles);
  const auto middle = [&](int a, int b) { return (fine.point(a) - fine.point(b)).norm() > longest_edge ? 0.5 : -1; };
  while (fine.number_of_triangles() * 4 <= most_triangles && fine.split_edges(middle)) {
  }
  return {fine.points(), fine.triangles()};
}

/// An appearance that encodes locations: triangles as materials, locations in them as texture coordinates.
Part_appearance numbered(Eigen::Index triangles)
{
  Part_appearance result;
  for (int t = 0; t < triangles; ++t) {
    result.materials.push_back(t);
    result.coordinates.insert(result.coordinates.end(), {{0, 0}, {1, 0}, {0, 1}});
  }
  return result;
}

/// A part subdivided so that its texture becomes colours of vertices.
Ply_part coloured(const Segmented_shape& shape, std::size_t part, double longest_edge,
                  const Transferred_appearance& transferred, bool has_labels)
{
  const auto& [name, mesh] = shape.parts()[part];
  Ply_part result{name, divided(mesh, longest_edge)};
  const Part_appearance places = appearance_on(mesh, numbered(mesh.triangles.cols()), result.mesh);
  const internal::Appearance_sampler looks(transferred.appearance, grey());
  Points colours = grey().replicate(1, result.mesh.points.cols());
  for (Eigen::Index i = 0; i < result.mesh.triangles.size(); ++i) {
    const Eigen::Vector2d at = places.coordinates[std::size_t(i)].cast<double>();
    colours.col(result.mesh.triangles.data()[i]) =
        looks(part, std::size_t(places.materials[std::size_t(i / 3)]), {1 - at.x() - at.y(), at.x(), at.y()});
  }
  for (const auto& colour : colours.colwise())
    for (double channel : srgb_colour(colour))
      result.colours.push_back(static_cast<std::uint8_t>(std::lround(255 * channel)));
  for (int given : places.materials)
    if (has_labels) result.labels.push_back(transferred.parts[part].labels[std::size_t(given)]);
  return result;
}

void write_coloured_ply(std::ostream& out, const Segmented_shape& shape, const Transferred_appearance& transferred,
                        const std::vector<std::string>& labels)
{
  const double longest_edge = internal::diagonal(internal::all_vertices(shape)) / edges_across;
  std::vector<Ply_part> parts;
  for (std::size_t i = 0; i < shape.parts().size(); ++i)
    parts.push_back(coloured(shape, i, longest_edge, transferred, !labels.empty()));
  write_ply(out, shape.up(), parts, labels);
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
    write_atomically(texture.string(), [&](std::ostream& out) { out << png; });
    write_atomically(library.string(), [&](std::ostream& out) {
      out << "newmtl transferred\nKd 1 1 1\nmap_Kd " << texture.filename().string() << '\n';
    });
    write_atomically(path, [&](std::ostream& out) {
      write_textured_obj(out, shape, transferred.appearance, library.filename().string());
    });
  } else
    throw Invalid_input(path + ": a shape with textures is written as .glb, .obj or .ply; name such a file");
}

} // namespace CGAL::Shape_correspondence::IO
