// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/library_call.h"
#include "shape/Flat_faces.h"
#include "shape/check_mesh.h"
#include "shape/meshes.h"
#include "shape/sample_triangles.h"
#include "shape/surface_tree.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/segment_mesh.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Tree = Surface_tree<Mesh_kernel, CGAL::AABB_face_graph_triangle_primitive<Halfedge_mesh>>;

// Lengths are fractions of the diagonal of the surface, angles are in radians.

// Weights of the log odds that neighbours are of one part, each for the feature in its comment. Fitted to meshes in one
// piece that were made of labelled and of generated shapes, by a logistic regression on the merges that the fit itself
// proposes.
constexpr double usual_odds = -1.2;         // the constant term
constexpr double odds_of_visibility = 3.8;  // share of the pairs of points that see each other through the inside
constexpr double odds_of_concavity = -2.3;  // mean concave angle along the common border
constexpr double odds_of_thickness = -0.57; // difference of the mean logarithms of the thickness

constexpr double detour = 8;             // relative lengthening of paths over a concave edge, per radian of its angle
constexpr double least_thickness = 1e-3; // lower bound, so that logarithms are finite
constexpr double deepest = 4e-3; // greatest depth below the surface of the points whose mutual visibility is tested
constexpr double depth_by_thickness = 0.3; // greatest depth of these points over the thickness
constexpr double above_rounding = 1e-5;    // depth at which rays begin, so that they do not meet their own face
constexpr double none = -std::numeric_limits<double>::infinity();

struct Face
{
  Point centre = Point::Zero(), normal = Point::Zero(), along = Point::Zero(); // along: direction of an edge
  double area = 0;

  bool is_flat() const { return area <= 0; } ///< it has no area, so that its normal is unknown
};

/// The angle between the normals of two adjacent faces where the surface is concave; 0 where it is convex.
double concave_angle(const Face& a, const Face& b)
{
  if (a.is_flat() || b.is_flat()) return 0;
  if ((b.centre - a.centre).dot(a.normal - b.normal) <= 0) return 0;
  return std::atan2(a.normal.cross(b.normal).norm(), a.normal.dot(b.normal));
}

/// Sets of patches of a surface, at first of one patch each, with the features that decide which neighbours to merge.
class Patches
{
public:
  Patches(Halfedge_mesh mesh, std::size_t count) : mesh_(std::move(mesh))
  {
    normalize();
    measure_faces();
    grow(std::min(count, faces_.size()));
    look_through_inside();
    measure_borders();
    for (Eigen::Index i = 0; i < size(); ++i)
      rate(i);
  }

  bool has_inside() const { return has_inside_; }

  /// Merges neighbours in descending order of their log odds, as long as these are above `odds`.
  void merge_down_to(double odds)
  {
    for (Eigen::Index i, j; odds_.maxCoeff(&i, &j) > std::max(odds, std::numeric_limits<double>::lowest());)
      merge(i, j);
  }

  /// Merges the smallest set with its neighbour of greatest odds, as long as it has less than a share of the area.
  void merge_smaller_than(double share)
  {
    for (Eigen::Index i, j; area_.minCoeff(&i) < share * total_area_ && odds_.row(i).maxCoeff(&j) > none;)
      merge(j, i);
  }

  /// For each face the number of its set; sets are numbered from 0 on in the order of their first faces.
  std::vector<std::size_t> of_faces() const
  {
    std::vector<std::size_t> result;
    std::map<Eigen::Index, std::size_t> numbers;
    for (Eigen::Index patch : patch_of_face_)
      result.push_back(numbers.try_emplace(set_of_patch_[std::size_t(patch)], numbers.size()).first->second);
    return result;
  }

private:
  Eigen::Index size() const { return Eigen::Index(seeds_.size()); }
  const Face& seed(Eigen::Index i) const { return faces_[seeds_[std::size_t(i)]]; }

  void normalize()
  {
    Eigen::AlignedBox3d box;
    for (auto vertex : mesh_.vertices())
      box.extend(to_point(mesh_.point(vertex)));
    const double diagonal = box.diagonal().norm();
    for (auto vertex : mesh_.vertices())
      mesh_.point(vertex) = to_mesh_point((to_point(mesh_.point(vertex)) - box.center()) / diagonal);
  }

  void measure_faces()
  {
    for (auto face : mesh_.faces()) {
      const auto halfedge = mesh_.halfedge(face);
      const Point a = to_point(mesh_.point(mesh_.source(halfedge))), b = to_point(mesh_.point(mesh_.target(halfedge))),
                  c = to_point(mesh_.point(mesh_.target(mesh_.next(halfedge))));
      const Point normal = (b - a).cross(c - a);
      faces_.push_back({(a + b + c) / 3, normal.normalized(), (b - a).normalized(), normal.norm() / 2});
      total_area_ += faces_.back().area;
    }
  }

  /// Grows patches from seed faces, each as far as possible from those before, along paths that avoid concave edges.
  void grow(std::size_t count)
  {
    using Reached = std::pair<double, std::size_t>;
    patch_of_face_.assign(faces_.size(), 0);
    std::vector<double> distance(faces_.size(), std::numeric_limits<double>::max());
    auto seed = std::size_t(
        std::max_element(faces_.begin(), faces_.end(), [](const Face& a, const Face& b) { return a.area < b.area; }) -
        faces_.begin());
    while (seeds_.size() < count && distance[seed] > 0) {
      const Eigen::Index patch = size();
      seeds_.push_back(seed);
      std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
      const auto reach = [&](std::size_t face, double way) {
        if (way >= distance[face]) return;
        distance[face] = way;
        patch_of_face_[face] = patch;
        front.emplace(way, face);
      };
      reach(seed, 0);
      while (!front.empty()) {
        const auto [way, face] = front.top();
        front.pop();
        if (way > distance[face]) continue;
        for (auto next : CGAL::faces_around_face(mesh_.halfedge(Halfedge_mesh::Face_index(unsigned(face))), mesh_)) {
          const Face &from = faces_[face], &to = faces_[next.idx()];
          reach(next.idx(), way + (to.centre - from.centre).norm() * (1 + detour * concave_angle(from, to)));
        }
      }
      for (std::size_t face = 0; face < faces_.size(); ++face)
        if (!faces_[face].is_flat() && distance[face] > distance[seed]) seed = face;
    }
  }

  /// A tree of all faces except those with collinear corners, on which intersections with rays fail.
  Tree tree_of_proper_faces() const
  {
    std::vector<Halfedge_mesh::Face_index> proper;
    for (auto face : mesh_.faces()) {
      const auto h = mesh_.halfedge(face);
      if (!CGAL::collinear(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)),
                           mesh_.point(mesh_.target(mesh_.next(h)))))
        proper.push_back(face);
    }
    return Tree(proper.begin(), proper.end(), mesh_);
  }

  /// The median length of rays from a face to the opposite side, within 39° of its inward normal; 0 if none hits.
  static double thickness_at(const Face& face, const Tree& tree)
  {
    const Point inward = -face.normal, across = inward.cross(face.along), from = face.centre + above_rounding * inward;
    std::vector<double> lengths;
    const auto measure = [&](double slope, double angle) {
      const Point ray = inward + slope * (std::cos(angle) * face.along + std::sin(angle) * across);
      if (ray.isZero()) return;
      const auto hit = tree.first_intersection(
          Mesh_kernel::Ray_3(to_mesh_point(from), Mesh_kernel::Vector_3(ray.x(), ray.y(), ray.z())));
      if (!hit) return;
      if (const auto* point = get_if<Mesh_point>(hit->first)) lengths.push_back((to_point(*point) - from).norm());
    };
    measure(0, 0);
    for (double slope : {0.35, 0.8})
      for (int k = 0; k < 6; ++k)
        measure(slope, slope + k * double(EIGEN_PI) / 3);
    if (lengths.empty()) return 0;
    const auto middle = lengths.begin() + std::ptrdiff_t(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
  }

  /// Measures the thickness at each seed face, and which seeds see each other through the inside.
  void look_through_inside()
  {
    const Tree tree = tree_of_proper_faces();
    thickness_.resize(size());
    std::vector<Mesh_point> eyes;
    for (Eigen::Index i = 0; i < size(); ++i) {
      const double thickness = thickness_at(seed(i), tree);
      has_inside_ = has_inside_ || thickness > 0;
      thickness_[i] = std::log(std::max(thickness, least_thickness));
      eyes.push_back(
          to_mesh_point(seed(i).centre - std::min(deepest, depth_by_thickness * thickness) * seed(i).normal));
    }
    visible_.setOnes(size(), size());
    for (Eigen::Index i = 0; i < size(); ++i)
      for (Eigen::Index j = 0; j < i; ++j) {
        const Mesh_point &a = eyes[std::size_t(i)], &b = eyes[std::size_t(j)];
        if (a != b && tree.do_intersect(Mesh_kernel::Segment_3(a, b))) visible_(i, j) = visible_(j, i) = 0;
      }
  }

  void measure_borders()
  {
    border_.setZero(size(), size());
    concavity_.setZero(size(), size());
    odds_.setConstant(size(), size(), none);
    members_.setOnes(size());
    area_.setZero(size());
    for (std::size_t face = 0; face < faces_.size(); ++face)
      area_[patch_of_face_[face]] += faces_[face].area;
    for (Eigen::Index i = 0; i < size(); ++i)
      set_of_patch_.push_back(i);
    for (auto halfedge : mesh_.halfedges()) {
      const std::size_t face = mesh_.face(halfedge).idx(), other = mesh_.face(mesh_.opposite(halfedge)).idx();
      const Eigen::Index i = patch_of_face_[face], j = patch_of_face_[other];
      if (i == j) continue;
      const double length =
          (to_point(mesh_.point(mesh_.source(halfedge))) - to_point(mesh_.point(mesh_.target(halfedge)))).norm();
      border_(i, j) += length;
      concavity_(i, j) += length * concave_angle(faces_[face], faces_[other]);
    }
  }

  /// Sets the log odds that set i and each of its neighbours are of one part.
  void rate(Eigen::Index i)
  {
    for (Eigen::Index j = 0; j < size(); ++j) {
      odds_(i, j) = odds_(j, i) = none;
      if (i == j || border_(i, j) <= 0) continue;
      odds_(i, j) = odds_(j, i) =
          usual_odds + odds_of_visibility * visible_(i, j) / (members_[i] * members_[j]) +
          odds_of_concavity * concavity_(i, j) / border_(i, j) +
          odds_of_thickness * std::abs(thickness_[i] / members_[i] - thickness_[j] / members_[j]);
    }
  }

  /// Merges set j into set i.
  void merge(Eigen::Index i, Eigen::Index j)
  {
    for (Eigen::MatrixXd* sums : {&visible_, &border_, &concavity_}) {
      sums->row(i) += sums->row(j);
      sums->col(i) += sums->col(j);
      sums->row(j).setZero();
      sums->col(j).setZero();
    }
    border_(i, i) = 0;
    members_[i] += members_[j];
    thickness_[i] += thickness_[j];
    area_[i] += area_[j];
    area_[j] = std::numeric_limits<double>::infinity(); // so that it is never the smallest
    std::replace(set_of_patch_.begin(), set_of_patch_.end(), j, i);
    odds_.row(j).setConstant(none);
    odds_.col(j).setConstant(none);
    rate(i);
  }

  Halfedge_mesh mesh_;
  std::vector<Face> faces_;
  double total_area_ = 0;
  bool has_inside_ = false;
  std::vector<std::size_t> seeds_; ///< indexed by patch: the face from which it grew
  std::vector<Eigen::Index> patch_of_face_, set_of_patch_;
  // Indexed by set of patches, or by two of them
  Eigen::VectorXd members_, area_, thickness_;          ///< thickness: sum of the patches' logarithms
  Eigen::MatrixXd visible_, border_, concavity_, odds_; ///< visible: number of pairs of seeds that see each other
};

/// Segments of a closed connected surface that are nearly convex, smooth or of one thickness.
/// \param patches number of patches that the segments are made of, at least 1
/// \return by face, the number of its segment; segments are numbered by their first faces; empty if no point of the
/// surface sees another one through the inside
/// \pre the mesh bounds a volume, and has no garbage
std::vector<std::size_t> convex_segments(const Halfedge_mesh& mesh, std::size_t patches,
                                         const Segmentation_options& options)
{
  Patches merged(mesh, patches);
  if (!merged.has_inside()) return {};
  merged.merge_down_to(std::log(options.probability / (1 - options.probability)));
  merged.merge_smaller_than(options.least_area);
  return merged.of_faces();
}

/// The mesh with its vertices and triangles in an order that does not depend on the file.
Part_mesh in_order(const Part_mesh& mesh)
{
  const Sorted_triangles sorted(mesh);
  Part_mesh result;
  result.points.resize(3, Eigen::Index(sorted.points.size()));
  result.triangles.resize(3, Eigen::Index(sorted.triangles.size()));
  for (std::size_t v = 0; v < sorted.points.size(); ++v)
    result.points.col(Eigen::Index(v)) = sorted.points[v];
  for (std::size_t t = 0; t < sorted.triangles.size(); ++t)
    result.triangles.col(Eigen::Index(t)) = Eigen::Vector3i(sorted.triangles[t].data());
  return result;
}

/// The connected components of the manifold that the triangles make; none if CGAL fails. \param areas gets their areas
std::vector<Halfedge_mesh> components_of(const Part_mesh& mesh, std::vector<double>& areas)
{
  return library_call(
      "components",
      [&] {
        Halfedge_mesh surface = manifold_surface(in_order(mesh));
        std::vector<Halfedge_mesh> components;
        CGAL::Polygon_mesh_processing::split_connected_components(surface, components);
        for (Halfedge_mesh& component : components) {
          component.collect_garbage();
          areas.push_back(CGAL::to_double(CGAL::Polygon_mesh_processing::area(component)));
        }
        return components;
      },
      [] { return std::vector<Halfedge_mesh>(); });
}

/// For each face, the number of its segment; none if the component has no inside, or CGAL fails.
std::vector<std::size_t> segments_of(Halfedge_mesh& component, std::size_t patches, const Segmentation_options& options)
{
  return library_call(
      "segments",
      [&] {
        CGAL::Polygon_mesh_processing::orient_to_bound_a_volume(component); // its inside is what is measured
        return convex_segments(component, patches, options);
      },
      [] { return std::vector<std::size_t>(); });
}

} // namespace
} // namespace CGAL::Shape_correspondence::internal

namespace CGAL::Shape_correspondence {
using namespace internal;

Mesh_segmentation segment_mesh(const Part_mesh& mesh, const Segmentation_options& options, std::string name,
                               const Point& up)
{
  if (options.patches < 1) throw Invalid_input("the number of patches of a segmentation is 0; give at least 1");
  if (!(options.probability > 0 && options.probability < 1) || !(options.least_area >= 0 && options.least_area <= 1))
    throw Invalid_input("the probability and the least area of a segmentation must be between 0 and 1");
  check_triangles(name, mesh);
  std::vector<double> areas;
  std::vector<Halfedge_mesh> components = components_of(mesh, areas);
  const double total_area = std::accumulate(areas.begin(), areas.end(), 0.);
  Mesh_segmentation result{Segmented_shape(std::move(name), up)};
  if (components.empty() && has_area(mesh)) {
    result.shape.add_part("segment_0", mesh);
    ++result.pieces_kept_whole;
  }
  for (std::size_t i = 0; i < components.size(); ++i) {
    Halfedge_mesh& component = components[i];
    if (!has_area(to_part_mesh(component))) {
      ++result.pieces_left_out;
      continue;
    }
    std::vector<std::size_t> segments;
    if (CGAL::is_closed(component)) {
      // Fewer patches for small components: the time is quadratic in the number of patches of a component, and the sum
      // of these times must not grow with the number of components
      const double patches = std::ceil(double(options.patches) * std::sqrt(areas[i] / total_area));
      const double most = double(component.number_of_faces());
      segments = segments_of(component, std::size_t(std::clamp(patches, 1., most)), options);
      if (segments.empty()) ++result.pieces_kept_whole;
    }
    segments.resize(component.number_of_faces(), 0);
    const auto meshes = meshes_of_segments(
        component, [&](auto face) { return segments[face.idx()]; }, component.points());
    for (const auto& [segment, mesh_of_segment] : meshes) {
      Part_mesh part{mesh_of_segment.points(), mesh_of_segment.triangles()};
      if (has_area(part))
        result.shape.add_part("segment_" + std::to_string(result.shape.parts().size()), std::move(part));
      else
        ++result.pieces_left_out;
    }
  }
  return result;
}

} // namespace CGAL::Shape_correspondence
