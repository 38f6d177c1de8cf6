// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"
#include "io/read/read_objects.h"
#include "io/write/Json.h"
#include "shape/Triangle_tree.h"
#include "shape/sample_triangles.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <numeric>
#include <optional>

// Compares the parts that are found in raw model files with labelled parts of the same shapes, by sample points on the
// labelled surfaces: Rand indices (Rand 1971; Hubert and Arabie 1985), F1 of parts, and the number of points that each
// labelled part has in common with each part found.

namespace CGAL::Shape_correspondence::benchmark {
namespace {

using internal::contacts::Sampled_triangle;
using internal::contacts::Triangle;
using internal::contacts::Triangle_tree;

constexpr int points_of_shape = 8000; // samples on a labelled shape
constexpr int points_of_part = 32;    // least number of samples on a part, so that small parts count
constexpr double found_share = 0.75;  // intersection over union above which a raw part is the labelled one
constexpr double same_place = 0.005;  // labelled samples farther from the raw surface do not count; over the diagonal

const char* const usage =
    "Usage: benchmark_parts [--parts auto|file|components|segments] [--roles FILE] [--obj FILE] RAW LABELLED [RAW "
    "LABELLED]...\n"
    "Writes a line of JSON for every pair of a raw model and a folder of labelled part meshes; with --obj, also the "
    "parts\n"
    "that are made of the last raw model, an object each.\n";

Part_splitting mode_of(const std::string& word)
{
  const std::map<std::string, Part_splitting> modes{{"auto", Part_splitting::AUTO},
                                                    {"file", Part_splitting::FILE},
                                                    {"components", Part_splitting::COMPONENTS},
                                                    {"segments", Part_splitting::SEGMENTS}};
  const auto found = modes.find(word);
  if (found == modes.end()) throw std::invalid_argument("--parts cannot be '" + word + "'");
  return found->second;
}

/// All triangles of a shape, and the part of each.
struct Surface
{
  std::vector<Triangle> triangles;
  std::vector<std::size_t> parts;
};

Surface surface_of(const Segmented_shape& shape)
{
  Surface result;
  for (std::size_t i = 0; i < shape.parts().size(); ++i) {
    const Part_mesh& mesh = shape.parts()[i].mesh;
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      result.triangles.push_back({mesh.points.col(mesh.triangles(0, t)), mesh.points.col(mesh.triangles(1, t)),
                                  mesh.points.col(mesh.triangles(2, t))});
      result.parts.push_back(i);
    }
  }
  return result;
}

/// Sample points on a surface; for each, the index of its part and the area that it represents.
struct Labelled_points
{
  std::vector<Point> points;
  std::vector<std::size_t> parts;
  std::vector<double> weights; ///< areas, scaled so that their sum is `points_of_shape`
};

/// Samples every part in proportion to its area, but with at least `points_of_part` points.
Labelled_points points_on(const Segmented_shape& shape)
{
  std::vector<std::vector<Sampled_triangle>> triangles;
  std::vector<double> areas;
  for (const Shape_part& part : shape.parts()) {
    triangles.push_back(internal::contacts::sampled_triangles_of(part.mesh));
    areas.push_back(internal::contacts::total_area(triangles.back()));
  }
  const double area = std::accumulate(areas.begin(), areas.end(), 0.);
  Labelled_points result;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const int n = std::max(points_of_part, int(std::lround(points_of_shape * areas[i] / area)));
    const internal::contacts::Surface_samples samples = internal::contacts::sample_triangles(triangles[i], n);
    result.points.insert(result.points.end(), samples.points.begin(), samples.points.end());
    result.parts.resize(result.points.size(), i);
    for (double of_sample : samples.areas)
      result.weights.push_back(of_sample / area * points_of_shape);
  }
  return result;
}

double diagonal_of(const std::vector<Point>& points)
{
  Eigen::AlignedBox3d box;
  for (const Point& p : points)
    box.extend(p);
  return box.diagonal().norm();
}

using Counts = std::vector<std::vector<double>>; // total weight of points, by labelled part and raw part

/// The weighted number of samples that each labelled part and each raw part have in common.
struct Common_points
{
  Counts counts;
  int quarter_turns = 0; ///< turns by 90° about the up axis that bring the labelled shape onto the raw one
};

Common_points common_points(const Labelled_points& labelled, std::size_t labelled_parts, const Segmented_shape& raw)
{
  const Surface surface = surface_of(raw);
  const Triangle_tree tree(surface.triangles);
  const double limit = same_place * diagonal_of(labelled.points);
  Common_points best;
  double most = -1;
  for (int turn = 0; turn < 4; ++turn) { // labelled shapes face +z, raw ones may face any side
    Counts counts(labelled_parts, std::vector<double>(raw.parts().size(), 0));
    double all = 0;
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(turn * EIGEN_PI / 2, Point::UnitY()).toRotationMatrix();
    for (std::size_t k = 0; k < labelled.points.size(); ++k) {
      Point nearest;
      double squared = limit * limit;
      std::size_t triangle = 0;
      if (!tree.improve_nearest(rotation * labelled.points[k], nearest, squared, triangle)) continue;
      counts[labelled.parts[k]][surface.parts[tree.given_number(triangle)]] += labelled.weights[k];
      all += labelled.weights[k];
    }
    if (all <= most) continue;
    most = all;
    best = {std::move(counts), turn};
  }
  return best;
}

struct Agreement
{
  double rand = 0, adjusted = 0; ///< Rand index, adjusted Rand index
  double f1 = 0;                 ///< of parts; raw parts without samples do not count
  double covered = 0;            ///< share of the labelled surface that is in the raw model
};

Agreement agreement_of(const Counts& counts)
{
  double all = 0, together = 0, rows = 0, columns = 0;
  std::vector<double> row_sums, column_sums(counts[0].size(), 0);
  for (const std::vector<double>& row : counts) {
    double sum = 0;
    for (std::size_t j = 0; j < row.size(); ++j) {
      together += row[j] * row[j];
      sum += row[j];
      column_sums[j] += row[j];
    }
    row_sums.push_back(sum);
    rows += sum * sum;
    all += sum;
  }
  for (double sum : column_sums)
    columns += sum * sum;
  const double pairs = all * all, expected = rows * columns / pairs, largest = (rows + columns) / 2;
  Agreement result;
  result.rand = 1 - (rows + columns - 2 * together) / pairs;
  result.adjusted = largest > expected ? (together - expected) / (largest - expected) : 1;
  result.covered = all / points_of_shape;
  double found = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    for (std::size_t j = 0; j < column_sums.size(); ++j)
      found += counts[i][j] > found_share * (row_sums[i] + column_sums[j] - counts[i][j]);
  const auto seen = std::count_if(column_sums.begin(), column_sums.end(), [](double sum) { return sum > 0; });
  result.f1 = 2 * found / double(counts.size() + std::size_t(seen));
  return result;
}

IO::Json names_of(const Segmented_shape& shape)
{
  IO::Json result = IO::Json::array();
  for (const Shape_part& part : shape.parts())
    result.push_back(part.name);
  return result;
}

void compare(const std::string& raw_path, const std::string& labelled_path, Part_splitting_options options,
             const Role_model* roles, const std::string& obj)
{
  const auto begin = std::chrono::steady_clock::now();
  IO::Model_objects model = IO::read_objects(raw_path, Point::UnitY());
  const Segmented_shape& objects = model.shape;
  const auto read = std::chrono::steady_clock::now();
  options.materials = std::move(model.materials);
  const Part_split of_model = IO::split_parts_by_roles(objects, options, roles);
  const Segmented_shape& parts = of_model.shape;
  const auto split = std::chrono::steady_clock::now();
  if (!obj.empty()) {
    std::ofstream out(obj);
    IO::write_segmented_shape_obj(out, parts);
    if (!out.flush()) throw std::invalid_argument(obj + " cannot be written; give a file in a folder that exists");
  }
  const Segmented_shape labelled = IO::read_segmented_shape(labelled_path);
  const Common_points common = common_points(points_on(labelled), labelled.parts().size(), parts);
  const Agreement agreement = agreement_of(common.counts);
  IO::Json shared = IO::Json::array();
  for (const std::vector<double>& row : common.counts)
    shared.push_back(IO::Json(row));
  const auto seconds = [](auto a, auto b) { return std::chrono::duration<double>(b - a).count(); };
  std::cout << IO::Json({{"raw", raw_path},
                         {"labelled", labelled_path},
                         {"objects", objects.parts().size()},
                         {"by_materials", of_model.by_materials},
                         {"rand", agreement.rand},
                         {"adjusted_rand", agreement.adjusted},
                         {"f1", agreement.f1},
                         {"covered", agreement.covered},
                         {"quarter_turns", common.quarter_turns},
                         {"read_seconds", seconds(begin, read)},
                         {"split_seconds", seconds(read, split)},
                         {"parts", names_of(parts)},
                         {"labelled_parts", names_of(labelled)},
                         {"common_points", std::move(shared)}})
                   .line()
            << std::endl;
}

} // namespace
} // namespace CGAL::Shape_correspondence::benchmark

int main(int argc, char** argv)
{
  using namespace CGAL::Shape_correspondence;
  try {
    benchmark::Command_line words(argc, argv);
    Part_splitting_options options;
    std::optional<Role_model> roles;
    std::vector<std::string> paths;
    std::string obj;
    while (!words.is_at_end()) {
      const std::string& word = words.word();
      if (word == "--parts") {
        options.mode = benchmark::mode_of(words.value());
        continue;
      }
      if (word == "--roles") {
        roles = IO::read_role_model(words.value());
        continue;
      }
      if (word == "--obj") {
        obj = words.value();
        continue;
      }
      benchmark::refuse_option(word);
      paths.push_back(word);
    }
    if (paths.empty() || paths.size() % 2 != 0) throw std::invalid_argument("inputs come in pairs");
    for (std::size_t i = 0; i < paths.size(); i += 2) {
      try {
        benchmark::compare(paths[i], paths[i + 1], options, roles ? &*roles : nullptr, obj);
      } catch (const Invalid_input& error) {
        std::cerr << error.what() << '\n';
      }
    }
  } catch (const std::invalid_argument& error) {
    std::cerr << "benchmark_parts: " << error.what() << '\n' << benchmark::usage;
    return 2;
  }
}
