// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/Surface_features.h"
#include "shape/meshes.h"
#include "shape/sample_triangles.h"
#include "shape/triangles_below.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstddef>
#include <set>

namespace CGAL::Shape_correspondence {

namespace internal {

namespace {

/// For each part, the objects that its triangles may be of. If the split lists no pieces: the object of the same index
/// if there are as many objects as parts, else any object.
std::vector<std::set<std::size_t>> objects_of_parts(const Segmented_shape& objects, const Part_split& split)
{
  std::vector<std::set<std::size_t>> result(split.shape.parts().size());
  for (const Model_piece& piece : split.pieces)
    if (piece.part != no_part) result[piece.part].insert(piece.object);
  const bool are_objects = objects.parts().size() == result.size();
  for (std::size_t part = 0; part < result.size(); ++part)
    for (std::size_t object = 0; split.pieces.empty() && object < objects.parts().size(); ++object)
      if (!are_objects || object == part) result[part].insert(object);
  return result;
}

} // namespace

void check_features(const std::string& what, const Eigen::MatrixXf& features)
{
  if (features.size() == 0) throw Invalid_input(what + ": there are no features; give some for each face or vertex");
  for (Eigen::Index column = 0; column < features.cols(); ++column)
    if (!features.col(column).allFinite())
      throw Invalid_input(what + ": row " + std::to_string(column) +
                          " of the features, counted from 0, has a number that is not finite, or beyond 3e38; give "
                          "zeros where there are no features");
}

Eigen::MatrixXd integrated(const Surface_features& features, const Segmented_shape& objects, const Part_split& split)
{
  const std::vector<std::set<std::size_t>> objects_of = objects_of_parts(objects, split);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(features.values.rows(), Eigen::Index(objects_of.size()));
  double total = 0;
  for (std::size_t part = 0; part < objects_of.size(); ++part) {
    std::vector<const Part_mesh*> meshes;
    std::vector<const int*> columns; // indexed by triangle of all meshes
    for (std::size_t object : objects_of[part]) {
      meshes.push_back(&objects.parts()[object].mesh);
      for (const auto& corners : features.columns[object].colwise())
        columns.push_back(corners.data());
    }
    const Part_mesh& mesh = split.shape.parts()[part].mesh;
    const std::vector<std::size_t> below = triangles_below(joined(meshes), mesh);
    const std::vector<contacts::Sampled_triangle> triangles = contacts::sampled_triangles_of(mesh);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int corner = 0; corner < 3; ++corner)
        result.col(Eigen::Index(part)) +=
            triangles[t].area / 3 * features.values.col(columns[below[t]][corner]).cast<double>();
    total += contacts::total_area(triangles);
  }
  if (total > 0) result /= total;
  return result;
}

} // namespace internal

Eigen::MatrixXd features_of_parts(const Eigen::MatrixXf& features, const Segmented_shape& objects,
                                  const Part_split& split)
{
  internal::check_features("features_of_parts", features);
  Eigen::Index triangles = 0, vertices = 0;
  for (const Shape_part& object : objects.parts()) {
    triangles += object.mesh.triangles.cols();
    vertices += object.mesh.points.cols();
  }
  const bool are_of_triangles = features.cols() == triangles;
  if (!are_of_triangles && features.cols() != vertices)
    throw Invalid_input("features_of_parts: there are " + std::to_string(features.cols()) + " rows of features, but '" +
                        objects.name() + "' has " + std::to_string(triangles) + " faces and " +
                        std::to_string(vertices) + " vertices; give one row for each face, or for each vertex");
  internal::Surface_features placed{features, {}};
  int first = 0;
  for (const Shape_part& object : objects.parts()) {
    const Eigen::Matrix3Xi& corners = object.mesh.triangles;
    const auto count = int(corners.cols());
    placed.columns.push_back(
        are_of_triangles
            ? Eigen::Matrix3Xi(Eigen::RowVectorXi::LinSpaced(count, first, first + count - 1).replicate(3, 1))
            : Eigen::Matrix3Xi(corners.array() + first));
    first += are_of_triangles ? count : int(object.mesh.points.cols());
  }
  return internal::integrated(placed, objects, split);
}

Eigen::MatrixXd features_of_parts(const Eigen::MatrixXf& features, const Segmented_shape& shape)
{
  return features_of_parts(features, shape, Part_split{shape, {}, {}});
}

} // namespace CGAL::Shape_correspondence
