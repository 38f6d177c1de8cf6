// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write/dressed_mesh.h"
#include "io/system/colours.h"

#include <array>
#include <tuple>

namespace CGAL::Shape_correspondence::IO {

bool Glb_materials::has_texture(int material) const
{
  if (material < 0) return false;
  const int number = appearance_.materials[std::size_t(material)].texture;
  return number >= 0 && !appearance_.textures[std::size_t(number)].bytes.empty();
}

Eigen::Vector4d Glb_materials::colour_of(int material, bool has_colours) const
{
  if (material >= 0) return appearance_.materials[std::size_t(material)].colour;
  Eigen::Vector4d result = Eigen::Vector4d::Ones();
  if (!has_colours) result.head<3>() = grey();
  return result;
}

int Glb_materials::texture(int number)
{
  const auto [known, is_new] = textures_.emplace(number, 0);
  if (is_new) known->second = glb_.add_texture(appearance_.textures[std::size_t(number)]);
  return known->second;
}

int Glb_materials::operator()(int material, bool has_colours)
{
  const auto [known, is_new] = materials_.emplace(std::pair(material, material < 0 && has_colours), 0);
  if (!is_new) return known->second;
  Surface_material result{"no material", Eigen::Vector4d::Ones(), -1};
  if (material >= 0) result = appearance_.materials[std::size_t(material)];
  result.colour = colour_of(material, has_colours);
  known->second = glb_.add_material(result, has_texture(material) ? texture(result.texture) : -1);
  return known->second;
}

std::vector<Dressed_mesh> dressed_meshes(const Eigen::Matrix3Xi& triangles, const Part_appearance& appearance)
{
  using Key = std::tuple<int, std::array<float, 2>, std::array<float, 3>>;
  struct Collector
  {
    Dressed_mesh mesh;
    std::map<Key, int> known;
    std::vector<Eigen::Vector3i> triangles;
  };
  std::map<int, Collector> by_material;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const int material = appearance.materials.empty() ? -1 : appearance.materials[std::size_t(t)];
    Collector& collector = by_material[material];
    Eigen::Vector3i corners;
    for (int k = 0; k < 3; ++k) {
      const std::size_t corner = 3 * std::size_t(t) + std::size_t(k);
      Key key{triangles(k, t), {}, {}};
      if (!appearance.coordinates.empty())
        std::get<1>(key) = {appearance.coordinates[corner].x(), appearance.coordinates[corner].y()};
      if (!appearance.colours.empty()) {
        const Eigen::Vector3f& colour = appearance.colours[corner];
        std::get<2>(key) = {colour.x(), colour.y(), colour.z()};
      }
      const auto [known, is_new] = collector.known.emplace(key, int(collector.mesh.points.size()));
      corners[k] = known->second;
      if (!is_new) continue;
      collector.mesh.points.push_back(triangles(k, t));
      if (!appearance.coordinates.empty()) collector.mesh.coordinates.push_back(appearance.coordinates[corner]);
      if (!appearance.colours.empty()) collector.mesh.colours.push_back(appearance.colours[corner]);
    }
    collector.triangles.push_back(corners);
  }
  std::vector<Dressed_mesh> result;
  for (auto& [material, collector] : by_material) {
    collector.mesh.material = material;
    collector.mesh.triangles.resize(3, Eigen::Index(collector.triangles.size()));
    for (std::size_t t = 0; t < collector.triangles.size(); ++t)
      collector.mesh.triangles.col(Eigen::Index(t)) = collector.triangles[t];
    result.push_back(std::move(collector.mesh));
  }
  return result;
}

std::vector<std::pair<Drawn_mesh, int>> dressed(const Drawn_mesh& mesh, const Part_appearance& appearance,
                                                Glb_materials& materials)
{
  std::vector<std::pair<Drawn_mesh, int>> result;
  for (Dressed_mesh& some : dressed_meshes(mesh.triangles, appearance)) {
    Drawn_mesh drawn;
    drawn.triangles = some.triangles;
    drawn.layer = mesh.layer;
    drawn.points.resize(3, Eigen::Index(some.points.size()));
    if (mesh.normals.cols() > 0) drawn.normals.resize(3, drawn.points.cols());
    for (std::size_t i = 0; i < some.points.size(); ++i) {
      drawn.points.col(Eigen::Index(i)) = mesh.points.col(some.points[i]);
      if (mesh.normals.cols() > 0) drawn.normals.col(Eigen::Index(i)) = mesh.normals.col(some.points[i]);
    }
    if (materials.has_texture(some.material)) drawn.coordinates = std::move(some.coordinates);
    const bool has_colours = !some.colours.empty();
    drawn.colours = std::move(some.colours);
    result.emplace_back(std::move(drawn), materials(some.material, has_colours));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
