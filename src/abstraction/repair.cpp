// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// fill_holes() does not use 3D Delaunay triangulations, so they need not be compiled
#define CGAL_HOLE_FILLING_DO_NOT_USE_DT3

#include "abstraction/repair.h"
#include "abstraction/curve_and_sheet_geometry.h"
#include "abstraction/holes.h"
#include "base/library_call.h"
#include "shape/meshes.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/alpha_wrap_3.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

/// Enclosed volume over area^1.5: 0.094 for a ball, 0.0035 for a plate with thickness 1/100 of its side.
double fullness(const Halfedge_mesh& mesh)
{
  const double area = PMP::area(mesh);
  return area > 0 ? PMP::volume(mesh) / (area * std::sqrt(area)) : 0.;
}

/// The manifold of the triangles, with coincident borders stitched.
Halfedge_mesh stitched_surface(const Part_mesh& part, bool& changed)
{
  Halfedge_mesh mesh = manifold_surface(part, &changed);
  changed |= PMP::stitch_borders(mesh) > 0;
  mesh.collect_garbage();
  return mesh;
}

void turn_outwards(Halfedge_mesh& mesh)
{
  if (PMP::volume(mesh) < 0) PMP::reverse_face_orientations(mesh);
}

/// The mesh of some faces. \param vertex_map scratch memory, indexed by vertex: null before and after the call
Halfedge_mesh submesh(const Halfedge_mesh& mesh, const std::vector<Halfedge_mesh::Face_index>& faces,
                      std::vector<Halfedge_mesh::Vertex_index>& vertex_map)
{
  Halfedge_mesh result;
  for (auto f : faces) {
    std::vector<Halfedge_mesh::Vertex_index> corners;
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
      Halfedge_mesh::Vertex_index& image = vertex_map[v.idx()];
      if (image == Halfedge_mesh::null_vertex()) image = result.add_vertex(mesh.point(v));
      corners.push_back(image);
    }
    result.add_face(corners);
  }
  for (auto f : faces) {
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      vertex_map[v.idx()] = Halfedge_mesh::null_vertex();
  }
  return result;
}

/// The connected components, the one of the largest area first. In linear time even with thousands of components.
/// \pre `mesh` has no garbage
std::vector<Halfedge_mesh> components_by_area(const Halfedge_mesh& mesh)
{
  std::vector<std::size_t> component(mesh.number_of_faces());
  const std::size_t n = PMP::connected_components(
      mesh, boost::make_iterator_property_map(component.begin(), CGAL::get(boost::face_index, mesh)));
  std::vector<std::vector<Halfedge_mesh::Face_index>> faces(n);
  std::vector<double> areas(n, 0.);
  for (auto f : mesh.faces()) {
    faces[component[f.idx()]].push_back(f);
    areas[component[f.idx()]] += PMP::face_area(f, mesh);
  }
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return areas[i] > areas[j]; });
  std::vector<Halfedge_mesh::Vertex_index> vertex_map(mesh.number_of_vertices(), Halfedge_mesh::null_vertex());
  std::vector<Halfedge_mesh> result;
  for (std::size_t c : order)
    result.push_back(submesh(mesh, faces[c], vertex_map));
  return result;
}

/// Whether points of a border stay distinct when CGAL's filling by a planar triangulation projects them along the mean
/// of the border's consistently oriented normals. If two points coincide, it crashes (CGAL 5.5).
bool projects_apart(const std::vector<Halfedge_mesh::Point>& border)
{
  constexpr double least_sine = 1e-6; // of the angle between the normal and the line through two points
  Mesh_kernel::Vector_3 normal(0, 0, 0);
  for (std::size_t i = 1; i + 1 < border.size(); ++i) {
    const auto n = CGAL::normal(border[0], border[i], border[i + 1]);
    const double side = n.x() != 0 ? n.x() : n.y() != 0 ? n.y() : n.z();
    normal = side > 0 ? normal + n : normal - n;
  }
  const double length = std::sqrt(normal.squared_length());
  for (std::size_t i = 0; i < border.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto apart = border[i] - border[j];
      const double across = std::sqrt(CGAL::cross_product(apart, normal).squared_length());
      if (!(across > least_sine * std::sqrt(apart.squared_length()) * length)) return false;
    }
  return true;
}

/// Closes all holes by flat or minimal patches. \throw Out_of_time
/// \return whether the result is a valid solid; otherwise `mesh` is unchanged
bool fill_holes(Halfedge_mesh& mesh, const Deadline& deadline)
{
  const double area = PMP::area(mesh);
  // A border of more edges is the rim of an open surface rather than of a hole; triangulating it takes cubic time.
  const std::size_t longest_border = 400;
  // Limit for the sum of the cubed lengths of all borders: that of about 30 of the longest ones
  const double most_work = 2e9;
  const double smallest_fullness = 1e-3;
  Halfedge_mesh filled = mesh;
  const std::vector<Halfedge_mesh::Halfedge_index> borders = borders_of(filled);
  double work = 0;
  for (auto h : borders) {
    const std::size_t length = halfedges_around_face(h, filled).size();
    work += std::pow(double(length), 3);
    if (length > longest_border || work > most_work) return false;
  }
  // A surface that intersects itself is left as it is: filling its holes would not change that.
  const double much_work = 1e5; // with less, self-intersections are looked for only after filling
  if (work > much_work && PMP::does_self_intersect(mesh)) return false;
  for (auto h : borders) {
    deadline.check();
    std::vector<Halfedge_mesh::Point> border;
    for (auto vertex : vertices_around_face(h, filled))
      border.push_back(filled.point(vertex));
    // The search in a 3D Delaunay triangulation does not always give the same patch
    const auto parameters = CGAL::parameters::use_2d_constrained_delaunay_triangulation(projects_apart(border))
                                .use_delaunay_triangulation(false);
    fill_hole(filled, h, parameters);
  }
  if (!CGAL::is_closed(filled) || PMP::does_self_intersect(filled)) return false;
  turn_outwards(filled);
  // Rejects the "holes" of a tyre that is open inside, which are larger than the surface.
  if (fullness(filled) < smallest_fullness || PMP::area(filled) > 2.1 * area) return false;
  mesh = std::move(filled);
  return true;
}

/// Orients a closed mesh outwards. \return whether it encloses more than next to nothing
bool is_solid(Halfedge_mesh& mesh)
{
  const double smallest_fullness = 1e-4;
  turn_outwards(mesh);
  return fullness(mesh) > smallest_fullness;
}

// Limit of the points that a wrap inserts at existing points; because of rounded distances, it may do so forever.
constexpr int most_repeated_points = 1000;

/// A visitor of CGAL's wrapping, which throws if this takes too long or does not terminate.
struct Wrap_watch
{
  explicit Wrap_watch(const Deadline& deadline) : deadline(&deadline) {}

  template <typename... Given>
  void on_alpha_wrapping_begin(const Given&...)
  {}
  template <typename... Given>
  void on_flood_fill_begin(const Given&...)
  {}
  template <typename... Given>
  bool go_further(const Given&...)
  {
    return true;
  }
  template <typename... Given>
  void before_facet_treatment(const Given&...)
  {
    deadline->check();
  }
  template <typename... Given>
  void before_Steiner_point_insertion(const Given&...)
  {}

  template <typename Wrapper, typename Vertex>
  void after_Steiner_point_insertion(const Wrapper& wrapper, const Vertex&)
  {
    const std::size_t now = wrapper.triangulation().number_of_vertices();
    if (now == vertices && ++repeated == most_repeated_points) throw Flow_failure("a surface around it is not found");
    vertices = now;
  }
  template <typename... Given>
  void on_flood_fill_end(const Given&...)
  {}
  template <typename... Given>
  void on_alpha_wrapping_end(const Given&...)
  {}

  const Deadline* deadline;
  std::size_t vertices = 0;
  int repeated = 0;
};

bool is_degenerate(const Triangle_soup& soup)
{
  return std::all_of(soup.triangles.begin(), soup.triangles.end(), [&](const auto& t) {
    return CGAL::collinear(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
  });
}

/// A closed surface around the part at a small distance. \throw Out_of_time, Flow_failure
Halfedge_mesh wrap(const Part_mesh& part, const Deadline& deadline)
{
  const double size = diagonal(part.points);
  const double alpha = size / 20, offset = size / 600;
  Halfedge_mesh result;
  Wrap_watch watch(deadline);
  const Triangle_soup soup = to_soup(part);
  if (is_degenerate(soup)) throw Flow_failure("its surface is too degenerate for the flow");
  // CGAL 5 takes the visitor from the parameters of the output, CGAL 6 from those of the input
  CGAL::alpha_wrap_3(soup.points, soup.triangles, alpha, offset, result, CGAL::parameters::visitor(std::ref(watch)),
                     CGAL::parameters::visitor(std::ref(watch)));
  turn_outwards(result);
  return result;
}

double box_diagonal(const Halfedge_mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin()) +
                   CGAL::square(box.zmax() - box.zmin()));
}

/// Whether a component, such as the tyre of a wheel with thin spokes, spans its part and has about half of its area.
bool dominates(const Halfedge_mesh& component, const Part_mesh& part, double area)
{
  return box_diagonal(component) > 0.9 * diagonal(part.points) && PMP::area(component) > 0.45 * area;
}

} // namespace

Repaired_part repair_part(const Part_mesh& part, const Deadline& deadline)
{
  using Repair = Abstraction_report::Repair;
  check_library_call("repair");
  Repaired_part result;
  bool soup_changed = false;
  const Halfedge_mesh mesh = stitched_surface(part, soup_changed);
  const double area = PMP::area(mesh);
  std::vector<Halfedge_mesh> components = components_by_area(mesh);
  result.several_components = components.size() > 1;
  result.repair = soup_changed ? Repair::SOUP : Repair::NONE;

  bool all_solid = true;
  std::vector<bool> solid;
  for (Halfedge_mesh& component : components) {
    deadline.check();
    const bool closed = CGAL::is_closed(component);
    solid.push_back(closed ? is_solid(component) : fill_holes(component, deadline));
    if (!closed && solid.back()) result.repair = Repair::HOLES;
    result.volume += solid.back() ? PMP::volume(component) : 0.;
    all_solid = all_solid && solid.back();
    if (!solid[0]) {
      break; // the part, or this component alone, will be wrapped
    }
  }
  const bool stands_alone = !components.empty() && dominates(components[0], part, area);
  if (stands_alone && solid[0]) {
    result.mesh = to_part_mesh(components[0]);
    return result;
  }
  deadline.check();
  // Of a wheel, only the tyre is wrapped: a wrap around the spokes, too, would close the ring.
  const Halfedge_mesh wrapped = wrap(stands_alone ? to_part_mesh(components[0]) : part, deadline);
  if (!all_solid) result.volume = PMP::volume(wrapped);
  Halfedge_mesh outer = components_by_area(wrapped).at(0);
  turn_outwards(outer);
  result.mesh = to_part_mesh(outer);
  result.repair = Repair::WRAP;
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
