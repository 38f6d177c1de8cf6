// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_DETECT_CONTACTS_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_DETECT_CONTACTS_IMPL_H

#include <CGAL/Shape_correspondence/detect_contacts.h>
#include <CGAL/Shape_correspondence/internal/contacts/Part_surface.h>
#include <CGAL/Shape_correspondence/internal/contacts/join_pieces.h>
#include <CGAL/assertions.h>

#include <limits>
#include <memory>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {
namespace contacts {

constexpr double SLACK = 1 + 1e-9;   ///< so that a gap of exactly the tolerance is a contact in every pose
constexpr double NEAR_BAND = 0.5;    ///< over the tolerance: what is this much farther than the least distance is near
constexpr int DISTANCE_SAMPLES = 64; ///< a part, to find the least distance
constexpr int REGION_SAMPLES = 64;   ///< a part, to find the middle of the contact
constexpr int PROJECTIONS = 6;       ///< from surface to surface, to refine the least distance
constexpr int ABSTRACTION_SAMPLES = 16; ///< of a curve, or along each side of a sheet

/// The near region of two surfaces.
struct Near_region
{
  double distance = std::numeric_limits<double>::infinity(); ///< the least found
  Point witness = Point::Zero();                             ///< half-way where it was found
  double limit = 0;                                          ///< up to this distance, points are near
  Box box;                                                   ///< of the near points
};

/// Samples of one surface and their distances from the other.
struct Measured_samples
{
  Surface_samples samples;
  std::vector<double> distances;

  Measured_samples(const Part_surface& from, const Box& region, int n, const Part_surface& to)
      : samples(from.sample(region, n))
  {
    for (const Point& p : samples.points)
      distances.push_back((to.nearest(p) - p).norm());
  }

  /// The index of the nearest sample; the number of samples if there are none.
  std::size_t nearest() const { return std::min_element(distances.begin(), distances.end()) - distances.begin(); }
};

/// Follows the nearest sample from surface to surface to where they are closest.
inline void refine(const Measured_samples& samples, const Part_surface& own, const Part_surface& other,
                   Near_region& region)
{
  const std::size_t best = samples.nearest();
  if (best == samples.distances.size() || samples.distances[best] >= region.distance) return;
  Point p = samples.samples.points[best], q = other.nearest(p);
  for (int i = 0; i < PROJECTIONS; ++i) {
    p = own.nearest(q);
    q = other.nearest(p);
  }
  region.distance = (q - p).norm();
  region.witness = (p + q) / 2;
}

/// The box of the samples that are within a limit.
inline void extend_by_near(const Measured_samples& samples, double limit, Box& box)
{
  for (std::size_t i = 0; i < samples.distances.size(); ++i)
    if (samples.distances[i] <= limit) box.extend(samples.samples.points[i]);
}

/// The least distance of the surfaces and what is at most by `band` farther, looked for where either is within `reach`
/// of the other's box.
inline Near_region near_region(const Part_surface& a, const Part_surface& b, double reach, double band)
{
  Near_region region;
  const Measured_samples on_a(a, widened(b.box(), reach), DISTANCE_SAMPLES, b);
  const Measured_samples on_b(b, widened(a.box(), reach), DISTANCE_SAMPLES, a);
  refine(on_a, a, b, region);
  refine(on_b, b, a, region);
  region.limit = region.distance + band;
  region.box.extend(region.witness);
  extend_by_near(on_a, region.limit, region.box);
  extend_by_near(on_b, region.limit, region.box);
  return region;
}

/// The middle of the samples that are within `limit`, by area.
inline bool middle(const Measured_samples& samples, double limit, Point& result)
{
  Point sum = Point::Zero();
  double area = 0;
  for (std::size_t i = 0; i < samples.distances.size(); ++i) {
    if (samples.distances[i] > limit) continue;
    sum += samples.samples.areas[i] * samples.samples.points[i];
    area += samples.samples.areas[i];
  }
  if (!(area > 0)) return false;
  result = sum / area;
  return true;
}

/// The middle of the near region, from samples that are denser than those it was found with.
inline Point middle(const Part_surface& a, const Part_surface& b, const Near_region& region)
{
  const Box box = widened(region.box, region.limit);
  Point on_a = region.witness, on_b = region.witness;
  const bool has_a = middle(Measured_samples(a, box, REGION_SAMPLES, b), region.limit, on_a);
  const bool has_b = middle(Measured_samples(b, box, REGION_SAMPLES, a), region.limit, on_b);
  return has_a && has_b ? Point((on_a + on_b) / 2) : has_a ? on_a : on_b;
}

/// Finds the contacts of parts with meshes, in the coordinates of a frame.
class Mesh_contacts
{
public:
  Mesh_contacts(const Segmented_shape& shape, const std::vector<Part_abstraction>& parts, const Shape_frame& frame,
                const Contact_options& options)
      : parts_(parts), frame_(frame)
  {
    Box box;
    for (const Shape_part& part : shape.parts()) {
      surfaces_.push_back(std::make_unique<Part_surface>(frame.to_frame(part.mesh.points), part.mesh.triangles));
      box.extend(surfaces_.back()->box());
    }
    diagonal_ = box.diagonal().norm();
    tolerance_ = options.tolerance * diagonal_;
  }

  std::vector<Contact> operator()(std::vector<std::string>& warnings)
  {
    std::vector<Near_pair> near;
    for (std::size_t a = 0; a < parts_.size(); ++a)
      for (std::size_t b = a + 1; b < parts_.size(); ++b)
        add_if_touching(a, b, near);
    join_pieces(
        parts_, diagonal_, [this](std::size_t a, std::size_t b) { return box_distance(a, b); },
        [this](std::size_t a, std::size_t b) { return near_pair(a, b); }, near, warnings);
    sort_by_parts(near);
    std::vector<Contact> contacts;
    for (const Near_pair& pair : near)
      contacts.push_back(contact(pair));
    return contacts;
  }

private:
  double box_distance(std::size_t a, std::size_t b) const
  {
    return surfaces_[a]->box().exteriorDistance(surfaces_[b]->box());
  }

  Contact contact(const Near_pair& pair) const
  {
    const auto [a, b] = pair.parts;
    const Point p = frame_.to_world(middle(*surfaces_[a], *surfaces_[b], regions_[pair.region]));
    return {pair.parts, {nearest_parameter(parts_[a], p), nearest_parameter(parts_[b], p)}};
  }

  Near_pair keep(std::size_t a, std::size_t b, double distance, const Near_region& region)
  {
    regions_.push_back(region);
    return {{a, b}, distance, regions_.size() - 1};
  }

  bool one_encloses_the_other(const Part_surface& a, const Part_surface& b) const
  {
    return (b.box().contains(a.box()) && b.encloses(a.any_point())) ||
           (a.box().contains(b.box()) && a.encloses(b.any_point()));
  }

  void add_if_touching(std::size_t a, std::size_t b, std::vector<Near_pair>& near)
  {
    if (box_distance(a, b) > tolerance_ * SLACK) return;
    const Part_surface &surface_a = *surfaces_[a], &surface_b = *surfaces_[b];
    const Near_region region = near_region(surface_a, surface_b, tolerance_ * SLACK, NEAR_BAND * tolerance_);
    if (!std::isfinite(region.distance)) return;
    const bool close = region.distance <= NEAR_BAND * tolerance_;
    if (!close && (surface_a.intersects(surface_b) || one_encloses_the_other(surface_a, surface_b)))
      near.push_back(keep(a, b, 0, region));
    else if (region.distance <= tolerance_ * SLACK)
      near.push_back(keep(a, b, region.distance, region));
  }

  /// The distance of two parts however far they are: what is found within the reach is the least.
  Near_pair near_pair(std::size_t a, std::size_t b)
  {
    double reach = std::max(tolerance_, box_distance(a, b)) * SLACK;
    Near_region region = near_region(*surfaces_[a], *surfaces_[b], reach, NEAR_BAND * tolerance_);
    while (region.distance > reach) {
      reach *= 2;
      region = near_region(*surfaces_[a], *surfaces_[b], reach, NEAR_BAND * tolerance_);
    }
    return keep(a, b, region.distance, region);
  }

  const std::vector<Part_abstraction>& parts_;
  const Shape_frame& frame_;
  std::vector<std::unique_ptr<Part_surface>> surfaces_;
  std::vector<Near_region> regions_;
  double diagonal_;
  double tolerance_;
};

/// The length of a curve.
inline double length(const Curve& curve)
{
  const Eigen::Index n = curve.points.cols();
  double sum = curve.closed ? (curve.points.col(0) - curve.points.col(n - 1)).norm() : 0;
  for (Eigen::Index i = 0; i + 1 < n; ++i)
    sum += (curve.points.col(i + 1) - curve.points.col(i)).norm();
  return sum;
}

/// The area of a sheet.
inline double area(const Sheet& sheet)
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

/// How far the surface is from the abstraction, of a part of even thickness: the radius of a rod, half the thickness
/// of a plate.
inline double half_thickness(const Part_abstraction& part)
{
  constexpr double PI = 3.14159265358979323846;
  const double extent =
      part.is_sheet() ? 2 * area(std::get<Sheet>(part.geometry)) : PI * length(std::get<Curve>(part.geometry));
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
      samples_.push_back(sample(part, ABSTRACTION_SAMPLES));
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
        if (pair.distance <= tolerance_ * SLACK) near.push_back(pair);
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
    return {pair.parts, {nearest_parameter(parts_[a], p), nearest_parameter(parts_[b], p)}};
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

} // namespace contacts
} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE
std::vector<Contact> detect_contacts(const Segmented_shape& shape, const std::vector<Part_abstraction>& parts,
                                     const Shape_frame& frame, const Contact_options& options,
                                     std::vector<std::string>& warnings)
{
  CGAL_precondition(shape.parts().size() == parts.size());
  return internal::contacts::Mesh_contacts(shape, parts, frame, options)(warnings);
}

CGAL_SHAPE_CORRESPONDENCE_INLINE
std::vector<Contact> detect_contacts(const std::vector<Part_abstraction>& parts, const Shape_frame& frame,
                                     const Contact_options& options, std::vector<std::string>& warnings)
{
  return internal::contacts::Abstraction_contacts(parts, frame, options)(warnings);
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_DETECT_CONTACTS_IMPL_H
