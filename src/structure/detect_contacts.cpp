// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/curve_and_sheet_geometry.h"
#include "base/for_each_index.h"
#include "base/limits.h"
#include "structure/Part_surface.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/detect_contacts.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <optional>

namespace CGAL::Shape_correspondence {
using namespace internal;
using namespace internal::contacts;

namespace {

/// Factor by which the tolerance is enlarged, so that a gap of exactly the tolerance is a contact in every pose.
constexpr double slack = 1 + 1e-9;
constexpr double near_band = 0.5;       ///< distance beyond the gap up to which samples are near, over the tolerance
constexpr double region_gap = 1.0 / 6;  ///< least distance between two regions, over the diagonal of all near samples
constexpr int region_samples = 64;      ///< samples of either surface for finding the regions of a contact
constexpr int abstraction_samples = 16; ///< samples of a curve, or along each side of a sheet

/// Samples of two surfaces, each near the other surface.
struct Near_samples
{
  std::vector<Point> points;
  std::vector<double> areas;
  std::vector<char> is_first; ///< whether a sample is on the first surface
};

/// A region where two surfaces touch: its centre, and the sum of its areas on both.
struct Region
{
  Point middle;
  double area;
};

/// Adds the samples of `from` that are within `limit` of `to`.
void add_near_samples(const Part_surface& from, const std::vector<char>& marked, const Box& box, const Part_surface& to,
                      double limit, bool is_first, Near_samples& result)
{
  const Surface_samples samples = from.sample(marked, box, region_samples);
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    if (!to.tree().is_near(samples.points[i], limit * limit)) continue;
    result.points.push_back(samples.points[i]);
    result.areas.push_back(samples.areas[i]);
    result.is_first.push_back(is_first);
  }
}

/// The two closest points, then samples of both surfaces within `limit` of the other one.
Near_samples near_samples(const Part_surface& a, const Part_surface& b, const Closest_pair& closest, double limit)
{
  const std::vector<char> near_a = a.tree().near_triangles(b.tree(), limit * limit);
  const std::vector<char> near_b = b.tree().near_triangles(a.tree(), limit * limit);
  const Box box_a = widened(a.box_of_marked(near_a), limit), box_b = widened(b.box_of_marked(near_b), limit);
  Near_samples result{{closest.first, closest.second}, {0, 0}, {1, 0}};
  add_near_samples(a, near_a, box_b, b, limit, true, result);
  add_near_samples(b, near_b, box_a, a, limit, false, result);
  return result;
}

/// Single-linkage clusters of points: those within the tolerance or `region_gap` are linked.
Disjoint_sets linked(const std::vector<Point>& points, double tolerance)
{
  Box box;
  for (const Point& p : points)
    box.extend(p);
  const double limit = std::max(tolerance, region_gap * box.diagonal().norm());
  Disjoint_sets pieces(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      if ((points[i] - points[j]).squaredNorm() <= limit * limit) pieces.unite(i, j);
  return pieces;
}

/// The region of one cluster. Its centre is the mean of the area-weighted centroids on both surfaces, or the mean of
/// the samples if these have no area.
Region region_of(const Near_samples& samples, const Disjoint_sets& pieces, std::size_t piece)
{
  std::array<Point, 2> sums = {Point::Zero(), Point::Zero()};
  std::array<double, 2> areas = {0, 0};
  Point sum = Point::Zero();
  std::size_t count = 0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    if (pieces[i] != piece) continue;
    sums[samples.is_first[i]] += samples.areas[i] * samples.points[i];
    areas[samples.is_first[i]] += samples.areas[i];
    sum += samples.points[i];
    ++count;
  }
  Point middle = Point::Zero();
  int sides = 0;
  for (int side = 0; side < 2; ++side)
    if (areas[side] > 0) {
      middle += sums[side] / areas[side];
      ++sides;
    }
  return {sides > 0 ? Point(middle / sides) : Point(sum / count), areas[0] + areas[1]};
}

/// The regions where two surfaces touch, the largest first; regions of less than `least_share` of its area are dropped.
std::vector<Region> regions(const Near_samples& samples, double tolerance)
{
  constexpr double least_share = 0.05; // ratio to the area of the largest region
  const Disjoint_sets pieces = linked(samples.points, tolerance);
  std::vector<Region> result;
  for (std::size_t i = 0; i < samples.points.size(); ++i)
    if (pieces[i] == i) result.push_back(region_of(samples, pieces, i));
  std::stable_sort(result.begin(), result.end(), [](const Region& a, const Region& b) { return a.area > b.area; });
  const double least = least_share * result.front().area;
  const auto is_small = [least](const Region& region) { return region.area <= least; };
  result.erase(std::remove_if(result.begin() + 1, result.end(), is_small), result.end());
  return result;
}

/// Finds the contacts of parts with meshes, in the coordinates of the frame.
class Mesh_contacts
{
public:
  Mesh_contacts(const Segmented_shape& shape, const std::vector<Part_abstraction>& parts, const Shape_frame& frame,
                const Contact_options& options)
      : parts_(parts), frame_(frame), closest_points_(options.closest_points)
  {
    Box box;
    surfaces_.reserve(parts.size());
    for (const Shape_part& part : shape.parts()) {
      surfaces_.emplace_back(frame.to_frame(part.mesh.points), part.mesh.triangles);
      box.extend(surfaces_.back().box());
    }
    diagonal_ = box.diagonal().norm();
    tolerance_ = options.tolerance * diagonal_;
  }

  template <typename ConcurrencyTag>
  std::vector<Contact> detect(std::vector<std::string>& warnings)
  {
    std::vector<Near_pair> near = touching_pairs<ConcurrencyTag>();
    join_pieces(
        parts_, diagonal_, [this](std::size_t a, std::size_t b) { return box_distance(a, b); },
        [this](std::size_t a, std::size_t b) { return numbered(a, b, closest(a, b)); }, near, warnings);
    sort_by_parts(near);
    std::vector<Contact> contacts(near.size());
    for_each_index<ConcurrencyTag>(near.size(), [&](std::size_t k) { contacts[k] = contact(near[k]); });
    return contacts;
  }

private:
  double box_distance(std::size_t a, std::size_t b) const
  {
    return surfaces_[a].box().exteriorDistance(surfaces_[b].box());
  }

  Contact contact(const Near_pair& pair) const
  {
    const auto [a, b] = pair.parts;
    if (closest_points_) {
      const Closest_pair& closest = closest_[pair.region];
      return {pair.parts,
              {nearest_parameter(parts_[a], frame_.to_world(closest.first)),
               nearest_parameter(parts_[b], frame_.to_world(closest.second))},
              {}};
    }
    const Near_samples samples =
        near_samples(surfaces_[a], surfaces_[b], closest_[pair.region], pair.distance + near_band * tolerance_);
    Contact result{pair.parts, {}, {}};
    for (const Region& region : regions(samples, tolerance_)) {
      const Point p = frame_.to_world(region.middle);
      result.further.push_back({nearest_parameter(parts_[a], p), nearest_parameter(parts_[b], p)});
    }
    result.parameters = result.further.front();
    result.further.erase(result.further.begin());
    return result;
  }

  /// The closest points of two parts, if they are closer than `limit`.
  Closest_pair closest(std::size_t a, std::size_t b, double limit = std::numeric_limits<double>::infinity()) const
  {
    Closest_pair result;
    result.squared = limit * limit;
    surfaces_[a].tree().improve_closest(surfaces_[b].tree(), result);
    return result;
  }

  Near_pair numbered(std::size_t a, std::size_t b, const Closest_pair& closest)
  {
    closest_.push_back(closest);
    return {{a, b}, std::sqrt(closest.squared), closest_.size() - 1};
  }

  std::optional<Closest_pair> touch(std::size_t a, std::size_t b) const
  {
    const double limit = tolerance_ * slack;
    const Closest_pair pair = closest(a, b, limit);
    if (std::sqrt(pair.squared) < limit) return pair;
    if (surfaces_[a].encloses(surfaces_[b]) || surfaces_[b].encloses(surfaces_[a])) return closest(a, b);
    return std::nullopt;
  }

  template <typename ConcurrencyTag>
  std::vector<Near_pair> touching_pairs()
  {
    std::vector<std::array<std::size_t, 2>> pairs;
    for (std::size_t a = 0; a < parts_.size(); ++a)
      for (std::size_t b = a + 1; b < parts_.size(); ++b)
        if (box_distance(a, b) <= tolerance_ * slack) pairs.push_back({a, b});
    std::vector<std::optional<Closest_pair>> closest(pairs.size());
    std::atomic<std::size_t> touching{0};
    for_each_index<ConcurrencyTag>(pairs.size(), [&](std::size_t k) {
      if (touching > most_contacts) return;
      closest[k] = touch(pairs[k][0], pairs[k][1]);
      if (closest[k]) ++touching;
    });
    if (touching > most_contacts)
      throw Invalid_input("more than " + std::to_string(most_contacts) +
                          " pairs of its parts touch; join parts, or remove those that lie in others");
    std::vector<Near_pair> result;
    for (std::size_t k = 0; k < pairs.size(); ++k)
      if (closest[k]) result.push_back(numbered(pairs[k][0], pairs[k][1], *closest[k]));
    return result;
  }

  const std::vector<Part_abstraction>& parts_;
  const Shape_frame& frame_;
  std::vector<Part_surface> surfaces_;
  std::vector<Closest_pair> closest_; ///< indexed by `Near_pair::region`
  bool closest_points_;
  double diagonal_;
  double tolerance_;
};

double area(const Sheet& sheet)
{
  double sum = 0;
  for (int i = 0; i + 1 < sheet.rows; ++i)
    for (int j = 0; j + 1 < sheet.cols; ++j) {
      const Point p = sheet.points.col(i * sheet.cols + j), q = sheet.points.col((i + 1) * sheet.cols + j + 1);
      const Point r = sheet.points.col(i * sheet.cols + j + 1), s = sheet.points.col((i + 1) * sheet.cols + j);
      sum += (q - p).cross(s - r).norm() / 2;
    }
  return sum;
}

/// Radius of a round rod, or half the thickness of an even plate, with the part's volume; 0 if unknown.
double half_thickness(const Part_abstraction& part)
{
  const double extent = part.is_sheet() ? 2 * area(std::get<Sheet>(part.geometry))
                                        : double(EIGEN_PI * arc_lengths(std::get<Curve>(part.geometry)).back());
  if (!(extent > 0) || !(part.volume > 0)) return 0;
  return part.is_sheet() ? part.volume / extent : std::sqrt(part.volume / extent);
}

/// Finds the contacts of parts without meshes.
class Abstraction_contacts
{
public:
  Abstraction_contacts(const std::vector<Part_abstraction>& parts, const Shape_frame& frame,
                       const Contact_options& options)
      : parts_(parts)
  {
    Box box;
    for (const Part_abstraction& part : parts) {
      samples_.push_back(sample(part, abstraction_samples));
      radii_.push_back(half_thickness(part));
      const Points local = frame.to_frame(samples_.back());
      for (Eigen::Index i = 0; i < local.cols(); ++i)
        box.extend(Point(local.col(i)));
    }
    diagonal_ = box.diagonal().norm() * frame.height;
    tolerance_ = options.tolerance * diagonal_;
  }

  std::vector<Contact> operator()(std::vector<std::string>& warnings)
  {
    std::vector<Near_pair> near;
    for (std::size_t a = 0; a < parts_.size(); ++a)
      for (std::size_t b = a + 1; b < parts_.size(); ++b) {
        const Near_pair pair = near_pair(a, b);
        if (pair.distance <= tolerance_ * slack) near.push_back(pair);
      }
    join_pieces(
        parts_, diagonal_, [](std::size_t, std::size_t) { return 0.0; },
        [this](std::size_t a, std::size_t b) { return near_pair(a, b); }, near, warnings);
    sort_by_parts(near);
    std::vector<Contact> contacts;
    for (const Near_pair& pair : near)
      contacts.push_back(contact(pair));
    return contacts;
  }

private:
  /// The sample of `from` nearest to the abstraction of `to`, and its distance.
  std::pair<double, Point> nearest_sample(std::size_t from, std::size_t to) const
  {
    std::pair<double, Point> best{std::numeric_limits<double>::infinity(), Point::Zero()};
    for (const auto& column : samples_[from].colwise()) {
      const Point p = column;
      const double distance = (evaluate(parts_[to], nearest_parameter(parts_[to], p)) - p).norm();
      if (distance < best.first) best = {distance, p};
    }
    return best;
  }

  Contact contact(const Near_pair& pair) const
  {
    const auto [a, b] = pair.parts;
    const Point& p = witnesses_[pair.region];
    return {pair.parts, {nearest_parameter(parts_[a], p), nearest_parameter(parts_[b], p)}, {}};
  }

  Near_pair near_pair(std::size_t a, std::size_t b)
  {
    const auto from_a = nearest_sample(a, b), from_b = nearest_sample(b, a);
    const auto& nearest = from_a.first <= from_b.first ? from_a : from_b;
    witnesses_.push_back(nearest.second);
    return {{a, b}, std::max(0.0, nearest.first - radii_[a] - radii_[b]), witnesses_.size() - 1};
  }

  const std::vector<Part_abstraction>& parts_;
  std::vector<Points> samples_;
  std::vector<double> radii_;
  std::vector<Point> witnesses_;
  double diagonal_;
  double tolerance_;
};

} // namespace

template <typename ConcurrencyTag>
std::vector<Contact> detect_contacts(const Segmented_shape& shape, const std::vector<Part_abstraction>& parts,
                                     const Shape_frame& frame, const Contact_options& options,
                                     std::vector<std::string>& warnings)
{
  CGAL_precondition(shape.parts().size() == parts.size());
  return Mesh_contacts(shape, parts, frame, options).detect<ConcurrencyTag>(warnings);
}

std::vector<Contact> detect_contacts(const std::vector<Part_abstraction>& parts, const Shape_frame& frame,
                                     const Contact_options& options, std::vector<std::string>& warnings)
{
  return Abstraction_contacts(parts, frame, options)(warnings);
}

template std::vector<Contact> detect_contacts<CGAL::Sequential_tag>(const Segmented_shape&,
                                                                    const std::vector<Part_abstraction>&,
                                                                    const Shape_frame&, const Contact_options&,
                                                                    std::vector<std::string>&);
template std::vector<Contact> detect_contacts<CGAL::Parallel_tag>(const Segmented_shape&,
                                                                  const std::vector<Part_abstraction>&,
                                                                  const Shape_frame&, const Contact_options&,
                                                                  std::vector<std::string>&);

} // namespace CGAL::Shape_correspondence
