// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/Solid_abstractor.h"
#include "abstraction/congruence.h"
#include "abstraction/curve_and_sheet_geometry.h"
#include "abstraction/repair.h"
#include "abstraction/surface_samples.h"
#include "base/directions.h"
#include "base/for_each_index.h"
#include "base/limits.h"
#include "shape/Flat_faces.h"
#include "shape/check_mesh.h"
#include "shape/convex_hull.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/abstract_part.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

/// A mesh that does not depend on the order of vertices and triangles, nor on rounding noise: coordinates are rounded
/// to a grid, equal vertices merged, duplicates removed, vertices and triangles sorted along a direction.
Part_mesh canonical_mesh(const Part_mesh& mesh, double grid)
{
  Part_mesh rounded = mesh;
  for (double& x : rounded.points.reshaped())
    x = std::round(x / grid) * grid;
  const Sorted_triangles sorted(rounded);
  if (sorted.triangles.empty()) {
    // The mesh is thinner than the grid: a finer one is tried.
    const double finer = 1e-4, finest = 1e-20; // ratio of the grids, and least grid that is refined
    return grid > finest ? canonical_mesh(mesh, finer * grid) : mesh;
  }
  std::vector<double> places;
  for (const Point& p : sorted.points)
    places.push_back(generic_direction().dot(p));
  return sorted_mesh(sorted.points, sorted.triangles, places);
}

/// The coordinate axis of the largest component; of nearly equal components, y, then x.
int dominant_axis(const Point& direction)
{
  const double nearly = 0.98; // least ratio of a component to the largest one
  const double longest = direction.cwiseAbs().maxCoeff();
  for (int axis : {1, 0, 2})
    if (std::abs(direction[axis]) >= nearly * longest) return axis;
  return 1;
}

bool points_backwards(const Point& direction) { return direction[dominant_axis(direction)] < 0; }

/// Orients a curve: an open one runs up, else to the side, else to the front; a closed one starts at its foremost point
/// and turns counter-clockwise about the coordinate axis nearest to its normal.
void make_canonical(Curve& curve)
{
  const Eigen::Index n = curve.points.cols();
  if (!curve.closed) {
    if (points_backwards(curve.points.col(n - 1) - curve.points.col(0)))
      curve.points = curve.points.rowwise().reverse().eval();
    return;
  }
  // Direction in which the foremost point is sought: oblique, so that no two points of a regular ring tie
  const Point front(0.13, 0.29, 1.);
  const std::vector<double> lengths = arc_lengths(curve);
  Point turn = Point::Zero();
  for (Eigen::Index i = 0; i < n; ++i)
    turn += curve.points.col(i).cross(curve.points.col((i + 1) % n));
  if (points_backwards(turn)) curve.points = curve.points.rowwise().reverse().eval();
  const int fine = 1024; // number of points that may become the start
  const Points dense = sample(curve, fine);
  Eigen::Index start = 0;
  (front.transpose() * dense).maxCoeff(&start);
  Curve turned = curve;
  turned.points.resize(3, fine);
  for (Eigen::Index i = 0; i < fine; ++i)
    turned.points.col(i) = dense.col((start + i) % fine);
  curve.points = sample(turned, int(n));
}

Sheet transposed(const Sheet& sheet)
{
  Sheet result = sheet;
  std::swap(result.rows, result.cols);
  for (int i = 0; i < sheet.rows; ++i) {
    for (int j = 0; j < sheet.cols; ++j)
      result.points.col(j * sheet.rows + i) = sheet.points.col(i * sheet.cols + j);
  }
  return result;
}

Point row_direction(const Sheet& sheet) { return sheet(1, 0) + sheet(1, 1) - sheet(0, 0) - sheet(0, 1); }
Point col_direction(const Sheet& sheet) { return sheet(0, 1) + sheet(1, 1) - sheet(0, 0) - sheet(1, 0); }

/// Orients a sheet: v runs to the side (or to the front, if the sheet does not extend sideways), u up or to the front.
void make_canonical(Sheet& sheet)
{
  const Point along_u = row_direction(sheet).normalized(), along_v = col_direction(sheet).normalized();
  const double u_side = std::abs(along_u.x()), v_side = std::abs(along_v.x());
  const bool side_decides = std::max(u_side, v_side) > 0.2 && std::abs(u_side - v_side) > 0.02;
  if (side_decides ? u_side > v_side : std::abs(along_u.z()) > std::abs(along_v.z()) + 0.02) sheet = transposed(sheet);
  const Eigen::Index rows = sheet.rows, cols = sheet.cols;
  if (points_backwards(row_direction(sheet))) {
    Sheet flipped = sheet;
    for (Eigen::Index i = 0; i < rows; ++i)
      flipped.points.middleCols(i * cols, cols) = sheet.points.middleCols((rows - 1 - i) * cols, cols);
    sheet = flipped;
  }
  if (points_backwards(col_direction(sheet))) {
    for (Eigen::Index i = 0; i < rows; ++i)
      sheet.points.middleCols(i * cols, cols) = sheet.points.middleCols(i * cols, cols).rowwise().reverse().eval();
  }
}

/// Grid to which coordinates are rounded, over the height of the shape (or the size of a single part). Remeshing and
/// flow would amplify rounding noise.
constexpr double coordinate_grid = 1e-7;

/// Diagonal, over the height of the shape, below which a part is abstracted in a frame of its own: differences of its
/// coordinates would be rounding noise.
constexpr double tiny_part = 1e-4;

constexpr std::size_t surface_points_of_a_part = 256;

void check(const Abstraction_options& options)
{
  constexpr double most_points = 1000; // limit for a curve, and for each side of a sheet
  if (!options.abstractor) throw Invalid_input("abstract_part: there is no abstractor; give one, or keep the default");
  check_positive("abstract_part: the edge length", options.edge_length);
  check_positive("abstract_part: the volume at which the flow stops", options.stop_volume);
  check_number("abstract_part: the number of triangles", options.triangles, 1);
  check_number("abstract_part: the number of iterations", options.maximum_iterations, 0);
  check_number("abstract_part: the time limit", options.time_limit, 0);
  check_number("abstract_part: the number of points of a curve", options.curve_points, 2, most_points);
  check_number("abstract_part: the number of points along a side of a sheet", options.sheet_points, 2, most_points);
}

bool is_valid(const Curve& curve) { return curve.points.cols() >= 2; }

bool is_valid(const Sheet& sheet)
{
  return sheet.rows >= 2 && sheet.cols >= 2 && sheet.points.cols() == Eigen::Index(sheet.rows) * sheet.cols;
}

/// Checks the result of a user's abstractor.
void check_abstraction(const std::string& name, const Part_abstraction& abstraction)
{
  const bool valid = std::visit([](const auto& g) { return is_valid(g); }, abstraction.geometry);
  if (!valid || !abstraction.control_points().allFinite()) {
    throw Invalid_input("part '" + name + "': the abstractor returned " +
                        (valid ? "points that are not finite" : "too few points") + "; correct it or use another one");
  }
}

Part_abstraction abstract_mesh(const Shape_part& part, const Abstraction_options& options)
{
  Stop_watch watch;
  Part_abstraction result = options.abstractor(part, options);
  check_abstraction(part.name, result);
  std::visit([](auto& g) { make_canonical(g); }, result.geometry);
  watch.lap();
  result.name = part.name;
  result.area = surface_area(part.mesh);
  result.surface = even_surface_points(part.mesh, surface_points_of_a_part);
  // `Fitted_abstraction` may have computed the hull; a hull from a user's abstractor is not used
  if (result.hull.cols() == 0 || !options.abstractor.target<Fitted_abstraction>())
    measure_hull(part.mesh.points, result);
  result.report.phases.measure = watch.lap();
  result.report.milliseconds = 1e3 * watch.seconds();
  return result;
}

void move_points(Part_abstraction& part, const std::function<Points(const Points&)>& motion)
{
  std::visit([&](auto& g) { g.points = motion(g.points); }, part.geometry);
  part.surface = motion(part.surface);
  part.hull = motion(part.hull);
}

void scale_measures(Part_abstraction& part, double factor)
{
  part.area *= factor * factor;
  part.volume *= factor * factor * factor;
  part.hull_volume *= factor * factor * factor;
}

Part_abstraction to_world(Part_abstraction part, const Shape_frame& frame)
{
  move_points(part, [&](const Points& points) { return frame.to_world(points); });
  scale_measures(part, frame.height);
  return part;
}

/// Abstracts a copy of the part that is centred at the origin and scaled to diagonal 1, and maps the result back.
Part_abstraction abstract_in_own_frame(const Shape_part& part, const Abstraction_options& options)
{
  const Point low = part.mesh.points.rowwise().minCoeff(), high = part.mesh.points.rowwise().maxCoeff();
  Shape_frame frame;
  frame.origin = 0.5 * (low + high);
  frame.height = (high - low).norm();
  const Part_mesh mesh = canonical_mesh({frame.to_frame(part.mesh.points), part.mesh.triangles}, coordinate_grid);
  return to_world(abstract_mesh({part.name, mesh}, options), frame);
}

void make_canonical(Part_abstraction& part)
{
  std::visit([](auto& g) { make_canonical(g); }, part.geometry);
}

Part_abstraction moved_copy(const Part_abstraction& original, const Motion& motion, const std::string& name)
{
  Part_abstraction result = original;
  result.name = name;
  result.report.method = Abstraction_report::Method::COPY;
  result.report.copy_of = original.name;
  result.report.milliseconds = 0;
  result.report.phases = {};
  move_points(result, motion);
  make_canonical(result);
  return result;
}

/// Counts the parts that are done, and reports the count to the caller.
class Progress
{
public:
  Progress(const Abstraction_options& options, std::size_t total) : options_(&options), total_(total) {}

  void one_done()
  {
    if (options_->progress) {
      const std::lock_guard<std::mutex> lock(mutex_);
      options_->progress(++done_, total_);
    }
  }

private:
  const Abstraction_options* options_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

/// The meshes of the parts in the shape's frame, in canonical form.
std::vector<Part_mesh> meshes_in_frame(const Segmented_shape& shape, const Shape_frame& frame)
{
  std::vector<Part_mesh> result;
  for (const Shape_part& part : shape.parts()) {
    const Points points = frame.to_frame(part.mesh.points);
    const double size = diagonal(points);
    result.push_back(canonical_mesh({points, part.mesh.triangles}, coordinate_grid * (size < tiny_part ? size : 1)));
  }
  return result;
}

/// Indices of the meshes that are not copies, the largest first, since they probably take longest.
std::vector<std::size_t> originals_by_size(const std::vector<Part_mesh>& meshes,
                                           const std::vector<Congruence>& congruences)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (congruences[i].original == i) result.push_back(i);
  std::stable_sort(result.begin(), result.end(), [&](std::size_t a, std::size_t b) {
    return meshes[a].triangles.cols() > meshes[b].triangles.cols();
  });
  return result;
}

} // namespace

Abstraction_kind Abstraction_options::kind_of(const std::string& part) const
{
  const auto found = part_kinds.find(part);
  return found == part_kinds.end() ? kind : found->second;
}

Part_abstraction abstract_part(const Shape_part& part, const Abstraction_options& options)
{
  check(options);
  check_mesh(part.name, part.mesh);
  Part_abstraction result = abstract_in_own_frame(part, options);
  if (options.progress) options.progress(1, 1);
  return result;
}

template <typename ConcurrencyTag>
std::vector<Part_abstraction> abstract_parts(const Segmented_shape& shape, const Shape_frame& frame,
                                             const Abstraction_options& options)
{
  check(options);
  const std::vector<Part_mesh> meshes = meshes_in_frame(shape, frame);
  const auto same_kind = [&](std::size_t i, std::size_t j) {
    return options.kind_of(shape.parts()[i].name) == options.kind_of(shape.parts()[j].name);
  };
  const std::vector<Congruence> congruences = find_congruences(meshes, same_kind);
  const std::vector<std::size_t> originals = originals_by_size(meshes, congruences);
  std::vector<Part_abstraction> result(meshes.size());
  Progress progress(options, meshes.size());
  for_each_index<ConcurrencyTag>(originals.size(), [&](std::size_t k) {
    const std::size_t i = originals[k];
    const Shape_part part{shape.parts()[i].name, meshes[i]};
    const bool is_tiny = diagonal(part.mesh.points) < tiny_part;
    result[i] = is_tiny ? abstract_in_own_frame(part, options) : abstract_mesh(part, options);
    progress.one_done();
  });
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const Congruence& congruence = congruences[i];
    if (congruence.original != i) {
      result[i] = moved_copy(result[congruence.original], congruence.motion, shape.parts()[i].name);
      progress.one_done();
    }
  }
  for (Part_abstraction& part : result)
    part = to_world(std::move(part), frame);
  return result;
}

Points sample_surface(const Part_mesh& mesh, std::size_t n)
{
  check_triangles("sample_surface", mesh);
  if (mesh.triangles.cols() == 0) throw Invalid_input("sample_surface: the mesh has no triangles; give one that has");
  return even_surface_points(mesh, n);
}

double convex_hull_volume(const Points& points)
{
  if (!points.allFinite()) throw Invalid_input("convex_hull_volume: the points must be finite");
  return convex_hull(points).volume;
}

template std::vector<Part_abstraction> abstract_parts<CGAL::Sequential_tag>(const Segmented_shape&, const Shape_frame&,
                                                                            const Abstraction_options&);
template std::vector<Part_abstraction> abstract_parts<CGAL::Parallel_tag>(const Segmented_shape&, const Shape_frame&,
                                                                          const Abstraction_options&);

} // namespace CGAL::Shape_correspondence
