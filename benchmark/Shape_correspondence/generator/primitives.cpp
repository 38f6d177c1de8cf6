// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "primitives.h"

namespace CGAL::Shape_correspondence::generator {

Mesh loft(const std::vector<Path>& rings, bool closed, const Point& first_tip, const Point& last_tip)
{
  Mesh mesh;
  const int m = int(rings.size()), n = int(rings.front().size());
  for (const Path& ring : rings)
    mesh.points.insert(mesh.points.end(), ring.begin(), ring.end());
  auto index = [&](int i, int j) { return (i % m) * n + j % n; };
  for (int i = 0; i < (closed ? m : m - 1); ++i)
    for (int j = 0; j < n; ++j) {
      mesh.faces.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      mesh.faces.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  if (closed) return outward(mesh);
  mesh.points.push_back(first_tip);
  mesh.points.push_back(last_tip);
  for (int j = 0; j < n; ++j) {
    mesh.faces.push_back({m * n, index(0, j + 1), index(0, j)});
    mesh.faces.push_back({m * n + 1, index(m - 1, j), index(m - 1, j + 1)});
  }
  return outward(mesh);
}

Point centroid(const Path& ring)
{
  Point sum = Point::Zero();
  for (const Point& p : ring)
    sum += p;
  return sum / double(ring.size());
}

Mesh loft(const std::vector<Path>& rings)
{
  return loft(rings, false, centroid(rings.front()), centroid(rings.back()));
}

Point tangent(const Path& path, bool closed, int i)
{
  const int n = int(path.size());
  const int before = closed ? (i + n - 1) % n : std::max(i - 1, 0);
  const int after = closed ? (i + 1) % n : std::min(i + 1, n - 1);
  return (path[after] - path[before]).normalized();
}

Path normals(const Path& path, bool closed, const Point& hint)
{
  const Point first = tangent(path, closed, 0);
  Path result{(hint - hint.dot(first) * first).normalized()};
  for (int i = 1; i < int(path.size()); ++i) {
    const Point step = path[i] - path[i - 1], old_tangent = tangent(path, closed, i - 1), old = result.back();
    auto reflected = [](const Point& v, const Point& by) -> Point { return v - 2 / by.squaredNorm() * by.dot(v) * by; };
    const Point flipped = reflected(old_tangent, step), now = tangent(path, closed, i), rest = now - flipped;
    const Point half_way = reflected(old, step);
    const Point normal = rest.squaredNorm() < 1e-20 ? half_way : reflected(half_way, rest);
    result.push_back((normal - normal.dot(now) * now).normalized());
  }
  return result;
}

bool is_plate(double length, double width, double thickness)
{
  constexpr double least_width = 0.18, most_thickness = 0.45, least_blade_width = 0.075, blade_thickness = 0.13;
  return (width >= least_width * length && thickness < most_thickness * width) ||
         (width >= least_blade_width * length && thickness <= blade_thickness * width);
}

Point point_at(const Path& path, double t)
{
  const int last = int(path.size()) - 1, k = std::min(int(t * last), last - 1);
  return between(path[k], path[k + 1], t * last - k);
}

void state_flat_tube(Solid& solid, const Path& path, const Path& across)
{
  solid.kind = Kind::sheet;
  solid.mid =
      sheet_grid([&](double u, double v) -> Point { return point_at(path, u) + (2 * v - 1) * point_at(across, u); });
}

Solid tube(Path path, const Section& section, Point hint, bool closed)
{
  if (std::abs(tangent(path, closed, 0).dot(hint)) > 0.9 * hint.norm()) hint = Point::UnitY();
  Solid solid;
  solid.kind = closed ? Kind::closed_curve : Kind::curve;
  solid.mid = path;
  std::vector<double> inset(path.size(), 0.);
  if (!closed) {
    const Point a = path[0], b = path[1], y = path[path.size() - 2], z = path.back();
    path.insert(path.begin() + 1, a + section.chamfer * (b - a).normalized());
    path.insert(path.end() - 1, z + section.chamfer * (y - z).normalized());
    inset.insert(inset.begin(), section.chamfer);
    inset.push_back(section.chamfer);
  }
  const Path normal = normals(path, closed, hint);
  const double whole = length(path);
  double done = 0;
  std::vector<Path> rings;
  for (int i = 0; i < int(path.size()); ++i) {
    if (i > 0) done += (path[i] - path[i - 1]).norm();
    const Point binormal = tangent(path, closed, i).cross(normal[i]);
    Path ring;
    for (const Point_2& p : section.ring(closed ? 0. : done / whole, inset[i]))
      ring.push_back(path[i] + p.x() * normal[i] + p.y() * binormal);
    rings.push_back(ring);
  }
  solid.mesh = closed ? loft(rings, true, Point::Zero(), Point::Zero()) : loft(rings);
  if (closed) return solid;
  Point_2 half = Point_2::Zero();
  for (const Point_2& p : section.ring(0.5, 0))
    half = half.cwiseMax(p.cwiseAbs());
  if (is_plate(whole, 2 * half.maxCoeff(), 2 * half.minCoeff())) {
    Path across;
    for (int i = 0; i < int(path.size()); ++i)
      across.push_back(half.maxCoeff() *
                       (half.x() > half.y() ? normal[i] : Point(tangent(path, closed, i).cross(normal[i]))));
    state_flat_tube(solid, path, across);
  }
  return solid;
}

Solid beam(const Point& from, const Point& to, const Section& section, int pieces)
{
  return tube(line(from, to, pieces), section);
}

Solid torus(const Point& centre, const Point& axis, double radius, const Section& section, int n)
{
  return tube(circle(centre, axis, radius, n), section, axis, true);
}

Path circle_about_y(double radius, double height, int n)
{
  Path ring;
  for (int j = 0; j < n; ++j) {
    const double angle = 2 * pi * (j + 0.5) / n;
    ring.push_back({radius * std::sin(angle), height, radius * std::cos(angle)});
  }
  return ring;
}

Mesh revolved(const Profile& profile, int n)
{
  std::vector<Path> rings;
  for (std::size_t i = 1; i + 1 < profile.size(); ++i)
    rings.push_back(circle_about_y(profile[i].x(), profile[i].y(), n));
  return loft(rings, false, {0, profile.front().y(), 0}, {0, profile.back().y(), 0});
}

Solid post(const Profile& profile, int n)
{
  auto lower = [](const Point_2& a, const Point_2& b) { return a.y() < b.y(); };
  const auto [low, high] = std::minmax_element(profile.begin(), profile.end(), lower);
  return {revolved(profile, n), Kind::curve, line({0, low->y(), 0}, {0, high->y(), 0})};
}

Point_2 square_to_disc(const Point_2& p)
{
  return {p.x() * std::sqrt(1 - p.y() * p.y() / 2), p.y() * std::sqrt(1 - p.x() * p.x() / 2)};
}

Solid disc(const Profile& profile, double radius, double height, int n)
{
  auto surface = [&](double u, double v) {
    const Point_2 p = radius * square_to_disc({2 * u - 1, 2 * v - 1});
    return Point(p.x(), height, p.y());
  };
  return {revolved(profile, n), Kind::sheet, sheet_grid(surface)};
}

Profile disc_profile(double radius, double low, double high, double bevel)
{
  return {{0, low},
          {radius / 2, low},
          {radius - bevel, low},
          {radius, low + bevel},
          {radius, high - bevel},
          {radius - bevel, high},
          {radius / 2, high},
          {0, high}};
}

Surface with_round_corners(const Surface& patch, double corner)
{
  return [=](double u, double v) {
    const double x = 2 * u - 1, y = 2 * v - 1;
    const double in_x = 1 - corner * std::pow(y, 4), in_y = 1 - corner * std::pow(x, 4);
    return patch((x * in_x + 1) / 2, (y * in_y + 1) / 2);
  };
}

Point normal_of(const Surface& surface, double u, double v)
{
  constexpr double h = 1e-4;
  const double u0 = std::max(u - h, 0.), u1 = std::min(u + h, 1.), v0 = std::max(v - h, 0.), v1 = std::min(v + h, 1.);
  return (surface(u1, v) - surface(u0, v)).cross(surface(u, v1) - surface(u, v0)).normalized();
}

std::vector<std::array<int, 2>> grid_border(int rows, int columns)
{
  std::vector<std::array<int, 2>> border;
  for (int i = 0; i < rows; ++i)
    border.push_back({i, 0});
  for (int j = 0; j < columns; ++j)
    border.push_back({rows, j});
  for (int i = rows; i > 0; --i)
    border.push_back({i, columns});
  for (int j = columns; j > 0; --j)
    border.push_back({0, j});
  return border;
}

void add_quad(Mesh& mesh, int a, int b, int c, int d)
{
  mesh.faces.push_back({a, b, c});
  mesh.faces.push_back({a, c, d});
}

std::vector<Point> slab_points(const Surface& surface, double thickness, const Slab_options& options)
{
  const double bevel = options.bevel * thickness, edge = thickness / 2 - bevel;
  const double inset_u = bevel / (surface(1, .5) - surface(0, .5)).norm();
  const double inset_v = bevel / (surface(.5, 1) - surface(.5, 0)).norm();
  auto point = [&](int i, int j, bool inset, double height) {
    const double s = double(i) / options.rows, t = double(j) / options.columns;
    const double u = inset ? s + inset_u * (1 - 2 * s) : s, v = inset ? t + inset_v * (1 - 2 * t) : t;
    return Point(surface(u, v) + height * normal_of(surface, u, v));
  };
  std::vector<Point> points;
  for (double height : {thickness / 2, -thickness / 2})
    for (int i = 0; i <= options.rows; ++i)
      for (int j = 0; j <= options.columns; ++j)
        points.push_back(point(i, j, true, height));
  for (double height : {edge, -edge})
    for (const auto& [i, j] : grid_border(options.rows, options.columns))
      points.push_back(point(i, j, false, height));
  return points;
}

Solid slab(const Surface& patch, double thickness, const Slab_options& options)
{
  const Surface surface = with_round_corners(patch, options.corner);
  const int rows = options.rows, columns = options.columns, layer = (rows + 1) * (columns + 1);
  auto index = [&](int i, int j) { return i * (columns + 1) + j; };
  Mesh mesh;
  mesh.points = slab_points(surface, thickness, options);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
      add_quad(mesh, a, b, c, d);
      add_quad(mesh, layer + a, layer + d, layer + c, layer + b);
    }
  const auto border = grid_border(rows, columns);
  const int n = int(border.size()), upper = 2 * layer, lower = upper + n;
  auto around = [&](int k) {
    const int top = index(border[k % n][0], border[k % n][1]);
    return std::array<int, 4>{top, upper + k % n, lower + k % n, layer + top};
  };
  for (int k = 0; k < n; ++k)
    for (int l = 0; l < 3; ++l)
      add_quad(mesh, around(k)[l], around(k)[l + 1], around(k + 1)[l + 1], around(k + 1)[l]);
  return plate_or_bar(outward(mesh), surface);
}

Surface flat(const Point& origin, const Point& u_edge, const Point& v_edge)
{
  return [=](double u, double v) -> Point { return origin + u * u_edge + v * v_edge; };
}

Solid board(const Point& middle, double width, double depth, double thickness, const Slab_options& options)
{
  return slab(flat(middle - Point(width / 2, 0, depth / 2), {0, 0, depth}, {width, 0, 0}), thickness, options);
}

double wing_half_thickness(double c)
{
  constexpr double nose = 1.48, trailing_edge = 0.06;
  return 0.5 * (nose * std::sqrt(c) * (1 - c) * (1.55 - 0.75 * c) + trailing_edge * c);
}

Path wing_ring(const Wing_station& station, const Point& upwards)
{
  constexpr int pieces = 6;
  Path ring;
  auto add = [&](double c, double side) {
    ring.push_back(station.leading_edge - Point(0, 0, c * station.chord) +
                   side * station.thickness * wing_half_thickness(c) * upwards);
  };
  auto spread = [](int i) { return (1 - std::cos(pi * i / pieces)) / 2; };
  for (int i = 0; i <= pieces; ++i)
    add(spread(i), 1);
  for (int i = pieces; i > 0; --i)
    add(spread(i), -1);
  return ring;
}

Solid wing(const std::vector<Wing_station>& stations, const Point& upwards, int pieces)
{
  const int last = int(stations.size()) - 1;
  auto at = [&](double s) {
    const int k = std::min(int(s * last), last - 1);
    const double t = s * last - k;
    const Wing_station &a = stations[k], &b = stations[k + 1];
    return Wing_station{between(a.leading_edge, b.leading_edge, t), a.chord + t * (b.chord - a.chord),
                        a.thickness + t * (b.thickness - a.thickness)};
  };
  std::vector<Path> rings;
  for (int i = 0; i <= last * pieces; ++i)
    rings.push_back(wing_ring(at(double(i) / (last * pieces)), upwards));
  auto surface = [&](double u, double v) {
    const Wing_station station = at(u);
    return Point(station.leading_edge - Point(0, 0, v * station.chord));
  };
  return plate_or_bar(loft(rings), surface);
}

Solid hull(const std::vector<Hull_station>& stations, int n, int pieces)
{
  Path middle_knots, size_knots;
  for (const Hull_station& s : stations) {
    middle_knots.push_back({0, s.y, s.z});
    size_knots.push_back({s.half_width, s.half_height, 0});
  }
  const Path middle = spline(middle_knots, pieces), size = spline(size_knots, pieces);
  std::vector<Path> rings;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    Path ring;
    for (int j = 0; j < n; ++j) {
      const double angle = 2 * pi * (j + 0.5) / n;
      ring.push_back(middle[i] + Point(size[i].x() * std::cos(angle), size[i].y() * std::sin(angle), 0));
    }
    rings.push_back(ring);
  }
  return {loft(rings), Kind::curve, middle};
}

} // namespace CGAL::Shape_correspondence::generator
