// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "texture/dressed_meshes.h"
#include "base/directions.h"
#include "io/read/model_parts.h"
#include "io/system/colours.h"
#include "texture/image_file.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/transfer_appearance.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr int wrap_numbers[] = {10497, 33648, 33071}; // glTF codes of the values of `Texture_wrap`

/// The appearance of a model on the drawn shape; empty if the model has none, or its textures are too large.
Shape_appearance drawn_appearance(const Segmented_shape* model, const Shape_appearance& looks,
                                  const Segmented_shape* drawn, std::size_t most_bytes)
{
  std::size_t bytes = 0;
  for (const Texture& texture : looks.textures)
    bytes += texture.bytes.size();
  if (!model || looks.empty() || bytes > most_bytes) return {};
  if (model == drawn) return looks;
  Shape_appearance result{looks.materials, looks.textures, {}, {}};
  for (std::size_t part = 0; part < model->parts().size(); ++part)
    result.parts.push_back(appearance_on(model->parts()[part].mesh, looks.parts[part], drawn->parts()[part].mesh));
  return result;
}

template <typename Vector>
auto columns(const std::vector<Vector>& values)
{
  using Columns = Eigen::Matrix<float, Vector::RowsAtCompileTime, Eigen::Dynamic>;
  return Eigen::Map<const Columns>(values.data()->data(), Vector::RowsAtCompileTime, Eigen::Index(values.size()));
}

constexpr int fade_steps = 5; // number of steps in which a part changes its colour in an animation

class Material_painter : public Blend_painter
{
public:
  Material_painter(Glb_file& glb, const Shape_blend& blend, const Blend_appearance& appearance)
      : glb_(glb),
        materials_{Glb_materials(glb, appearance.source), Glb_materials(glb, appearance.target)},
        surfaces_(blend.surfaces())
  {
    const std::array<Segmented_shape, 2> shapes = {blend(0), blend(1)};
    const std::array<std::vector<Points>, 2> points = {blend.points(0), blend.points(1)};
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const Blend_task& task = surfaces_[i].task;
      const auto side = std::size_t(surfaces_[i].side);
      const std::size_t part = side == 0 ? task.source : task.target;
      looks_.push_back({appearance_on(shapes[side].parts()[part].mesh, materials_[side].of_part(part),
                                      {points[side][i], surfaces_[i].triangles}),
                        fade_of(task)});
    }
  }

  std::vector<Drawn_mesh> end(std::size_t side, std::size_t part, const Drawn_mesh& mesh) override
  {
    return materials_[side].dressed(mesh, part);
  }

  std::vector<double> changes(std::size_t surface) const override
  {
    std::vector<double> result;
    const Blend_task& task = surfaces_[surface].task;
    for (int step = 1; looks_[surface].fade && step < fade_steps; ++step)
      result.push_back(task.begin + step * (task.end - task.begin) / fade_steps);
    return result;
  }

  std::vector<Painted_mesh> surface(std::size_t surface, double t) override
  {
    const auto& [appearance, fade] = looks_[surface];
    return materials_[std::size_t(surfaces_[surface].side)].dressed(
        surfaces_[surface].triangles, appearance, fade ? faded(*fade, surfaces_[surface].task, t) : -1);
  }

private:
  /// The first and the last colour of a transition.
  using Fade = std::array<Eigen::Vector4d, 2>;

  struct Looks
  {
    Part_appearance appearance;
    std::optional<Fade> fade; ///< defined if both parts have a single colour, and these differ
  };

  std::optional<Fade> fade_of(const Blend_task& task) const
  {
    if (task.source == Blend_task::no_part || task.target == Blend_task::no_part) return std::nullopt;
    const auto from = materials_[0].only_colour(task.source), to = materials_[1].only_colour(task.target);
    if (!from || !to || *from == *to) return std::nullopt;
    return Fade{*from, *to};
  }

  int faded(const Fade& fade, const Blend_task& task, double t)
  {
    const double f = task.end > task.begin ? std::clamp((t - task.begin) / (task.end - task.begin), 0., 1.) : t;
    const Eigen::Vector4d mixed = (1 - f) * fade[0] + f * fade[1];
    const auto [known, is_new] = faded_.emplace(std::array<double, 4>{mixed[0], mixed[1], mixed[2], mixed[3]}, 0);
    if (is_new) known->second = glb_.add_material("faded", mixed.head<3>(), mixed[3]);
    return known->second;
  }

  Glb_file& glb_;
  std::array<Glb_materials, 2> materials_;
  std::vector<Blend_surface> surfaces_;
  std::vector<Looks> looks_;
  std::map<std::array<double, 4>, int> faded_;
};

} // namespace

bool Glb_materials::has_texture(int material) const
{
  if (material < 0) return false;
  const int number = appearance_.materials[std::size_t(material)].texture;
  return number >= 0 && !appearance_.textures[std::size_t(number)].bytes.empty();
}

Eigen::Vector4d Glb_materials::colour_of(int material, bool has_colours) const
{
  if (material >= 0) return appearance_.materials[std::size_t(material)].colour;
  return Colour(has_colours ? Colour::Ones() : grey()).homogeneous();
}

const Part_appearance& Glb_materials::of_part(std::size_t part) const
{
  static const Part_appearance unknown;
  return part < appearance_.parts.size() ? appearance_.parts[part] : unknown;
}

int Glb_materials::texture_in_file(int number)
{
  const auto [known, is_new] = textures_.emplace(number, 0);
  if (!is_new) return known->second;
  const Texture& texture = appearance_.textures[std::size_t(number)];
  const char* const type = is_png(texture.bytes) ? "image/png" : "image/jpeg";
  const int view = glb_.add_bytes(texture.bytes);
  const int image = glb_.add("images", {{"name", texture.name}, {"mimeType", type}, {"bufferView", view}});
  const int sampler = glb_.add(
      "samplers", {{"wrapS", wrap_numbers[int(texture.wrap_u)]}, {"wrapT", wrap_numbers[int(texture.wrap_v)]}});
  return known->second = glb_.add("textures", {{"source", image}, {"sampler", sampler}});
}

int Glb_materials::in_file(int material, bool has_colours)
{
  const auto [known, is_new] = materials_.emplace(std::pair(material, material < 0 && has_colours), 0);
  if (!is_new) return known->second;
  const Surface_material* const own = material < 0 ? nullptr : &appearance_.materials[std::size_t(material)];
  const Eigen::Vector4d colour = colour_of(material, has_colours);
  const int number = has_texture(material) ? texture_in_file(own->texture) : -1;
  return known->second = glb_.add_material(own ? own->name : "no material", colour.head<3>(), colour[3], number);
}

std::optional<Eigen::Vector4d> Glb_materials::only_colour(std::size_t part) const
{
  const Part_appearance& looks = of_part(part);
  const int material = looks.materials.empty() ? -1 : looks.materials[0];
  const auto is_other = [&](int number) { return number != material; };
  if (!looks.colours.empty() || std::any_of(looks.materials.begin(), looks.materials.end(), is_other) ||
      has_texture(material))
    return std::nullopt;
  return colour_of(material, false);
}

std::vector<Blend_painter::Painted_mesh> Glb_materials::dressed(const Eigen::Matrix3Xi& triangles,
                                                                const Part_appearance& looks, int instead)
{
  struct Collector
  {
    std::map<std::tuple<int, std::array<float, 2>, std::array<float, 3>>, int> known;
    std::vector<int> points, corners, triangles; ///< point and one corner of each new vertex; new vertices of triangles
  };
  const bool has_coordinates = !looks.coordinates.empty(), has_colours = !looks.colours.empty();
  std::map<int, Collector> by_material;
  for (Eigen::Index i = 0; i < triangles.size(); ++i) {
    const auto corner = std::size_t(i);
    Collector& all = by_material[looks.materials.empty() ? -1 : looks.materials[corner / 3]];
    const int point = triangles.data()[i];
    std::array<float, 2> at{};
    std::array<float, 3> colour{};
    if (has_coordinates) std::copy_n(looks.coordinates[corner].data(), 2, at.data());
    if (has_colours) std::copy_n(looks.colours[corner].data(), 3, colour.data());
    const auto [known, is_new] = all.known.emplace(std::tuple(point, at, colour), int(all.points.size()));
    all.triangles.push_back(known->second);
    if (!is_new) continue;
    all.points.push_back(point);
    all.corners.push_back(int(i));
  }
  std::vector<Blend_painter::Painted_mesh> result;
  for (auto& [material, all] : by_material) {
    Blend_painter::Painted_mesh painted;
    painted.mesh.triangles =
        Eigen::Map<Eigen::Matrix3Xi>(all.triangles.data(), 3, Eigen::Index(all.triangles.size()) / 3);
    if (has_coordinates && has_texture(material))
      painted.mesh.coordinates = columns(looks.coordinates)(Eigen::indexing::all, all.corners);
    if (has_colours) painted.mesh.colours = columns(looks.colours)(Eigen::indexing::all, all.corners);
    painted.mesh.material = instead >= 0 ? instead : in_file(material, has_colours);
    painted.points = std::move(all.points);
    result.push_back(std::move(painted));
  }
  return result;
}

std::vector<Drawn_mesh> Glb_materials::dressed(const Drawn_mesh& mesh, std::size_t part)
{
  std::vector<Drawn_mesh> result;
  for (auto& [drawn, points] : dressed(mesh.triangles, of_part(part))) {
    drawn.layer = mesh.layer;
    drawn.points = mesh.points(Eigen::indexing::all, points);
    if (mesh.normals.cols() > 0) drawn.normals = mesh.normals(Eigen::indexing::all, points);
    result.push_back(std::move(drawn));
  }
  return result;
}

Add_scenes dressed_scenes(std::vector<std::pair<const Segmented_shape*, const Shape_appearance*>> models,
                          std::size_t most_bytes)
{
  return [=](Glb_file& glb, const std::vector<Placed_shape>& shapes, std::vector<Glb_scene>& scenes) {
    std::vector<Shape_appearance> looks;
    for (std::size_t i = 0; i < shapes.size(); ++i)
      looks.push_back(drawn_appearance(models[i].first, *models[i].second, shapes[i].shape.model(), most_bytes));
    if (std::all_of(looks.begin(), looks.end(), std::mem_fn(&Shape_appearance::empty))) return;
    scenes.push_back({material_layer, {}});
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      Glb_materials materials(glb, looks[i]);
      const auto draw = [&](std::size_t part) {
        Drawn_mesh mesh = shapes[i].shape.best_mesh(part);
        mesh.layer = material_layer;
        return materials.dressed(mesh, part);
      };
      scenes.back().roots.push_back(shapes[i].shape.add_to(glb, shapes[i].place, draw));
    }
  };
}

void write_segmented_shape_glb(std::ostream& out, const Segmented_shape& shape, const Shape_appearance& appearance)
{
  const auto turn = internal::least_rotation(shape.up(), Point::UnitY()).toRotationMatrix(); // the up axis of glTF is y
  Glb_file glb;
  Glb_materials materials(glb, appearance);
  std::vector<int> nodes;
  for (std::size_t part = 0; part < shape.parts().size(); ++part) {
    const auto& [name, mesh] = shape.parts()[part];
    nodes.push_back(glb.add_node(name, materials.dressed(shaded(turn * mesh.points, mesh.triangles), part)));
    glb.set_node_extras(nodes.back(), {{"part", part}});
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

void write_blend_glb(std::ostream& out, const Shape_blend& blend, const Blend_appearance& appearance, int frames)
{
  Glb_file glb;
  Material_painter painter(glb, blend, appearance);
  write_blend_animation(out, blend, frames, glb, painter);
}

void write_blend_frame_glb(std::ostream& out, const Shape_blend& blend, const Blend_appearance& appearance, double t)
{
  Glb_file glb;
  Material_painter painter(glb, blend, appearance);
  write_blend_frame(out, blend, t, glb, painter);
}

} // namespace CGAL::Shape_correspondence::IO
