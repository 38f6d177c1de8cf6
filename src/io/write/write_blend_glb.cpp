// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "base/limits.h"
#include "io/write/Json.h"
#include "io/write/drawn_shape.h"
#include "io/write/dressed_mesh.h"
#include "io/write/picture_geometry.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <ostream>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double hold_seconds = 0.5, motion_seconds = 2;
constexpr int fade_steps = 5; // of a colour in an animation

double seconds_at(double t) { return hold_seconds + t * motion_seconds; }

/// The points of a mesh by their numbers.
Points chosen(const Points& points, const std::vector<int>& numbers)
{
  Points result(3, Eigen::Index(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    result.col(Eigen::Index(i)) = points.col(numbers[i]);
  return result;
}

/// How a surface of a blend is drawn.
class Surface_painter
{
public:
  /// A mesh with a material of the file.
  struct Painted
  {
    Dressed_mesh mesh;
    int material;
  };

  virtual ~Surface_painter() = default;
  virtual std::vector<std::pair<Drawn_mesh, int>> end(int side, std::size_t part, const Drawn_mesh& mesh) = 0;
  /// Times, besides the surface's own, at which it changes its looks.
  virtual std::vector<double> changes(std::size_t surface) = 0;
  virtual std::vector<Painted> surface(std::size_t surface, double t) = 0;
};

Dressed_mesh whole_mesh(const Points& points, const Eigen::Matrix3Xi& triangles)
{
  Dressed_mesh result;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    result.points.push_back(int(i));
  result.triangles = triangles;
  return result;
}

/// By the colours of corresponding parts.
class Match_painter : public Surface_painter
{
public:
  Match_painter(Glb_builder& glb, const Shape_blend& blend, const Correspondence& correspondence, std::size_t sources,
                std::size_t targets)
      : surfaces_(blend.surfaces()),
        points_(blend.points(0)),
        sources_(sources),
        materials_(add_match_materials(glb, correspondence, sources, targets))
  {}

  std::vector<std::pair<Drawn_mesh, int>> end(int side, std::size_t part, const Drawn_mesh& mesh) override
  {
    return {{mesh, materials_[side == 0 ? part : sources_ + part]}};
  }

  std::vector<double> changes(std::size_t) override { return {}; }

  std::vector<Painted> surface(std::size_t surface, double) override
  {
    const Blend_task& task = surfaces_[surface].task;
    const std::size_t part = task.source != Blend_task::no_part ? task.source : sources_ + task.target;
    return {{whole_mesh(points_[surface], surfaces_[surface].triangles), materials_[part]}};
  }

private:
  std::vector<Blend_surface> surfaces_;
  std::vector<Points> points_;
  std::size_t sources_;
  std::vector<int> materials_;
};

/// By the materials of the shapes.
class Material_painter : public Surface_painter
{
public:
  Material_painter(Glb_builder& glb, const Shape_blend& blend, const Blend_appearance& appearance)
      : glb_(glb),
        appearance_{&appearance.source, &appearance.target},
        materials_{Glb_materials(glb, appearance.source), Glb_materials(glb, appearance.target)},
        surfaces_(blend.surfaces())
  {
    const std::array<Segmented_shape, 2> shapes = {blend(0), blend(1)};
    const std::array<std::vector<Points>, 2> points = {blend.points(0), blend.points(1)};
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const Blend_task& task = surfaces_[i].task;
      const std::array<std::size_t, 2> parts = {task.source, task.target};
      // A part that corresponds has two surfaces: the source's, then the target's
      const bool is_second = i > 0 && surfaces_[i].name == surfaces_[i - 1].name;
      const std::size_t side = task.source == Blend_task::no_part || is_second ? 1 : 0;
      Looks looks{side, {}, {}};
      for (std::size_t s = 0; s < 2; ++s)
        if (parts[s] != Blend_task::no_part) looks.colour[s] = only_colour(s, parts[s]);
      if (parts[side] < appearance_[side]->parts.size())
        looks.appearance = appearance_on(shapes[side].parts()[parts[side]].mesh, appearance_[side]->parts[parts[side]],
                                         {points[side][i], surfaces_[i].triangles});
      looks_.push_back(std::move(looks));
    }
  }

  std::vector<std::pair<Drawn_mesh, int>> end(int side, std::size_t part, const Drawn_mesh& mesh) override
  {
    const auto s = std::size_t(side);
    const Part_appearance none;
    return dressed(mesh, part < appearance_[s]->parts.size() ? appearance_[s]->parts[part] : none, materials_[s]);
  }

  std::vector<double> changes(std::size_t surface) override
  {
    std::vector<double> result;
    const Blend_task& task = surfaces_[surface].task;
    for (int step = 1; fades(surface) && step < fade_steps; ++step)
      result.push_back(task.begin + step * (task.end - task.begin) / fade_steps);
    return result;
  }

  std::vector<Painted> surface(std::size_t surface, double t) override
  {
    const Looks& looks = looks_[surface];
    const bool fade = fades(surface);
    std::vector<Painted> result;
    for (Dressed_mesh& mesh : dressed_meshes(surfaces_[surface].triangles, looks.appearance)) {
      if (!materials_[looks.side].has_texture(mesh.material)) mesh.coordinates.clear();
      const int material = fade ? faded(surface, t) : materials_[looks.side](mesh.material, !mesh.colours.empty());
      result.push_back({std::move(mesh), material});
    }
    return result;
  }

private:
  struct Looks
  {
    std::size_t side;
    Part_appearance appearance;
    std::array<std::optional<Eigen::Vector4d>, 2> colour; ///< of the parts at both ends, where they have one
  };

  /// The colour of a part that is of one colour.
  std::optional<Eigen::Vector4d> only_colour(std::size_t side, std::size_t part) const
  {
    int material = -1;
    if (part < appearance_[side]->parts.size()) {
      const Part_appearance& looks = appearance_[side]->parts[part];
      if (!looks.colours.empty()) return std::nullopt;
      if (!looks.materials.empty()) material = looks.materials[0];
      for (int other : looks.materials)
        if (other != material) return std::nullopt;
    }
    if (materials_[side].has_texture(material)) return std::nullopt;
    return materials_[side].colour_of(material, false);
  }

  bool fades(std::size_t surface) const
  {
    const auto& colour = looks_[surface].colour;
    return colour[0] && colour[1] && *colour[0] != *colour[1];
  }

  int faded(std::size_t surface, double t)
  {
    const Blend_task& task = surfaces_[surface].task;
    const double f = task.end > task.begin ? std::clamp((t - task.begin) / (task.end - task.begin), 0., 1.) : t;
    const auto& colour = looks_[surface].colour;
    const Eigen::Vector4d mixed = (1 - f) * *colour[0] + f * *colour[1];
    const auto [known, is_new] = faded_.emplace(std::array<double, 4>{mixed[0], mixed[1], mixed[2], mixed[3]}, 0);
    if (is_new) known->second = glb_.add_material(Surface_material{"faded", mixed, -1}, -1);
    return known->second;
  }

  Glb_builder& glb_;
  std::array<const Shape_appearance*, 2> appearance_;
  std::array<Glb_materials, 2> materials_;
  std::vector<Blend_surface> surfaces_;
  std::vector<Looks> looks_;
  std::map<std::array<double, 4>, int> faded_;
};

/// The shape at an end.
int add_end(Glb_builder& glb, const Segmented_shape& shape, int side, Surface_painter& painter)
{
  std::vector<int> nodes;
  for (std::size_t part = 0; part < shape.parts().size(); ++part) {
    const Part_mesh& mesh = shape.parts()[part].mesh;
    nodes.push_back(
        glb.add_node(shape.parts()[part].name, painter.end(side, part, shaded(mesh.points, mesh.triangles))));
    std::array<int, 2> parts{-1, -1};
    parts[std::size_t(side)] = int(part);
    glb.set_node_extras(nodes.back(), {{"parts", Json::array({parts[0], parts[1]})}});
  }
  return glb.add_node(shape.name(), nodes, Point::Zero());
}

Json parts_of(const Blend_task& task)
{
  Json parts = Json::array();
  for (std::size_t end : {task.source, task.target})
    parts.push_back(end == Blend_task::no_part ? -1 : int(end));
  return {{"parts", parts}};
}

/// The points of all surfaces by frame.
std::vector<std::vector<Points>> points_of_frames(const Shape_blend& blend, int frames)
{
  std::vector<std::vector<Points>> points(static_cast<std::size_t>(frames));
  internal::for_each_index<CGAL::Parallel_if_available_tag>(
      points.size(), [&](std::size_t frame) { points[frame] = blend.points(double(frame) / (frames - 1)); });
  return points;
}

void write_animation(std::ostream& out, const Shape_blend& blend, int frames, Glb_builder& glb,
                     Surface_painter& painter)
{
  internal::check_number_of_frames(frames);
  const Segmented_shape source = blend(0), target = blend(1);
  std::vector<int> roots = {add_end(glb, source, 0, painter)};
  glb.animate_visibility(roots[0], 0, hold_seconds);
  const std::vector<Blend_surface> surfaces = blend.surfaces();
  const std::vector<std::vector<Points>> points = points_of_frames(blend, frames);
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    std::vector<double> times{surfaces[s].begin};
    for (double change : painter.changes(s))
      if (change > times.back() && change < surfaces[s].end) times.push_back(change);
    times.push_back(surfaces[s].end);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      if (times[i] >= times[i + 1]) continue;
      // One more before and after the frames in which it is there
      const int first = int(std::floor(times[i] * (frames - 1))), last = int(std::ceil(times[i + 1] * (frames - 1)));
      std::vector<double> seconds;
      for (int frame = first; frame <= last; ++frame)
        seconds.push_back(seconds_at(double(frame) / (frames - 1)));
      std::vector<Glb_builder::Morphing_mesh> meshes;
      for (Surface_painter::Painted& painted : painter.surface(s, (times[i] + times[i + 1]) / 2)) {
        Glb_builder::Morphing_mesh mesh{{},
                                        painted.mesh.triangles,
                                        painted.material,
                                        std::move(painted.mesh.coordinates),
                                        std::move(painted.mesh.colours)};
        for (int frame = first; frame <= last; ++frame)
          mesh.shapes.push_back(chosen(points[std::size_t(frame)][s], painted.mesh.points));
        meshes.push_back(std::move(mesh));
      }
      const int node = glb.add_morphing_node(surfaces[s].name, meshes);
      glb.animate_shapes(node, seconds);
      glb.animate_visibility(node, seconds_at(times[i]), seconds_at(times[i + 1]));
      glb.set_node_extras(node, parts_of(surfaces[s].task));
      roots.push_back(node);
    }
  }
  roots.push_back(add_end(glb, target, 1, painter));
  glb.animate_visibility(roots.back(), seconds_at(1), seconds_at(1) + hold_seconds);
  glb.set_animation_extras({{"begin", seconds_at(0)}, {"end", seconds_at(1)}});
  glb.write(out, {{"blend", roots}});
}

} // namespace

void write_blend_glb(std::ostream& out, const Shape_blend& blend, const Correspondence& correspondence, int frames)
{
  Glb_builder glb;
  Match_painter painter(glb, blend, correspondence, blend(0).parts().size(), blend(1).parts().size());
  write_animation(out, blend, frames, glb, painter);
}

void write_blend_glb(std::ostream& out, const Shape_blend& blend, const Blend_appearance& appearance, int frames)
{
  Glb_builder glb;
  Material_painter painter(glb, blend, appearance);
  write_animation(out, blend, frames, glb, painter);
}

void write_blend_frame_glb(std::ostream& out, const Shape_blend& blend, const Blend_appearance& appearance, double t)
{
  Glb_builder glb;
  Material_painter painter(glb, blend, appearance);
  if (t <= 0 || t >= 1) {
    const int side = t <= 0 ? 0 : 1;
    glb.write(out, {{"blend", {add_end(glb, blend(side), side, painter)}}});
    return;
  }
  const std::vector<Blend_surface> surfaces = blend.surfaces();
  const std::vector<Points> points = blend.points(t);
  std::vector<int> nodes;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (t <= surfaces[s].begin || t >= surfaces[s].end) continue;
    std::vector<std::pair<Drawn_mesh, int>> meshes;
    for (Surface_painter::Painted& painted : painter.surface(s, t))
      meshes.emplace_back(Drawn_mesh{chosen(points[s], painted.mesh.points),
                                     {},
                                     painted.mesh.triangles,
                                     {},
                                     {},
                                     std::move(painted.mesh.coordinates),
                                     std::move(painted.mesh.colours)},
                          painted.material);
    nodes.push_back(glb.add_node(surfaces[s].name, meshes));
    glb.set_node_extras(nodes.back(), parts_of(surfaces[s].task));
  }
  glb.write(out, {{"blend", {glb.add_node("blend", nodes, Point::Zero())}}});
}

} // namespace CGAL::Shape_correspondence::IO
