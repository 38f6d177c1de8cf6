// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/documents/collection_json.h"
#include "base/number_text.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/IO/matrix_files.h>

#include <algorithm>
#include <ostream>

namespace CGAL::Shape_correspondence::IO {
namespace {

Json shapes_json(const Collection& collection)
{
  Json result = Json::array();
  for (const Collection::Shape& shape : collection.shapes)
    result.push_back({{"name", shape.name}, {"file", shape.file}, {"parts", shape.parts}});
  return result;
}

Json energies_json(const Collection& collection)
{
  Json result = Json::array();
  for (std::size_t i = 0; i < collection.shapes.size(); ++i) {
    result.push_back(Json::array());
    for (std::size_t j = 0; j < collection.shapes.size(); ++j)
      result.back().push_back(collection.energy(i, j));
  }
  return result;
}

double distance(const Collection& collection, std::size_t i, std::size_t j)
{
  return (collection.energy(i, j) + collection.energy(j, i)) / 2;
}

Json medoid_json(const Collection& collection)
{
  const std::size_t n = collection.shapes.size();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    sum += distance(collection, collection.medoid, i);
  return {{"shape", collection.shapes[collection.medoid].name},
          {"mean_distance", sum / double(std::max<std::size_t>(1, n - 1))}};
}

Json tree_json(const Collection& collection)
{
  Json result = Json::array();
  for (const auto& [a, b] : collection.tree)
    result.push_back(
        {{"shapes", {collection.shapes[a].name, collection.shapes[b].name}}, {"distance", distance(collection, a, b)}});
  return result;
}

void set_pairs(Json& result, const Part_map& map, const Collection::Shape& source, const Collection::Shape& target)
{
  Json pairs = Json::array(), confidences = Json::array();
  for (const Part_correspondence& pair : map.pairs) {
    pairs.push_back({source.parts[pair.source], target.parts[pair.target]});
    confidences.push_back(pair.confidence);
  }
  result["pairs"] = std::move(pairs);
  result["confidences"] = std::move(confidences);
}

Json bridges_json(const Collection& collection)
{
  Json result = Json::array();
  for (const Collection::Bridge& bridge : collection.bridges) {
    const Transitive_correspondence& way = bridge.correspondence;
    const Collection::Shape &source = collection.shapes[bridge.source], &target = collection.shapes[bridge.target];
    Json chain = Json::array();
    for (std::size_t shape : way.chain.shapes)
      chain.push_back(collection.shapes[shape].name);
    result.push_back({{"source", source.name},
                      {"target", target.name},
                      {"chain", chain},
                      {"energy", way.chain.energy},
                      {"direct_energy", way.direct_energy}});
    set_pairs(result.back(), way.map, source, target);
  }
  return result;
}

Json matches_json(const Collection& collection)
{
  Json result = Json::array();
  for (const Shape_pair_map& match : collection.matches) {
    const Collection::Shape &source = collection.shapes[match.source], &target = collection.shapes[match.target];
    result.push_back({{"source", source.name}, {"target", target.name}});
    set_pairs(result.back(), match.map, source, target);
  }
  return result;
}

Json clusters_json(const Collection& collection)
{
  std::vector<Json> parts(std::size_t(collection.co_analysis.number_of_labels), Json::array());
  for (std::size_t shape = 0; shape < collection.shapes.size(); ++shape)
    for (std::size_t part = 0; part < collection.shapes[shape].parts.size(); ++part) {
      const int label = collection.co_analysis.labels[shape][part];
      if (label != Co_analysis::none)
        parts[std::size_t(label)].push_back({collection.shapes[shape].name, collection.shapes[shape].parts[part]});
    }
  Json result = Json::array();
  for (std::size_t label = 0; label < parts.size(); ++label)
    result.push_back({{"label", label}, {"parts", std::move(parts[label])}});
  return result;
}

constexpr std::size_t npy_alignment = 64;

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "files of doubles are written as they are in memory");

constexpr Eigen::Index rows_at_a_time = 512; // rows of a block: so many entries of a column fill a page of 4 kB

/// Calls `take` with every row. Rows are read in blocks, since the columns are contiguous in memory.
template <typename Take>
void for_each_row(const Eigen::Ref<const Eigen::MatrixXd>& matrix, const Take& take)
{
  for (Eigen::Index first = 0; first < matrix.rows(); first += rows_at_a_time) {
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows =
        matrix.middleRows(first, std::min(rows_at_a_time, matrix.rows() - first));
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      take(first + i, rows.row(i));
  }
}

} // namespace

Json collection_outline_json(const Collection& collection)
{
  return {{"format", "shape_correspondence/collection"},
          {"version", 1},
          {"shapes", shapes_json(collection)},
          {"medoid", medoid_json(collection)},
          {"spanning_tree", tree_json(collection)}};
}

void write_collection_json(std::ostream& out, const Collection& collection)
{
  Json result = collection_outline_json(collection);
  result["bridge_count"] = collection.bridge_count;
  result["bridges"] = bridges_json(collection);
  result["co_analysis"] = {{"shape_pairs", collection.co_analysis_shape_pairs},
                           {"part_pairs", collection.co_analysis.part_pairs},
                           {"rejected_part_pairs", collection.co_analysis.rejected_pairs}};
  result["clusters"] = clusters_json(collection);
  if (collection.shapes.size() <= largest_written_matrix) result["energies"] = energies_json(collection);
  if (!collection.matches.empty()) result["matches"] = matches_json(collection);
  result["warnings"] = collection.warnings;
  result.write(out);
}

void write_nearest_json(std::ostream& out, const Nearest_in_collection& found)
{
  Json result;
  result["format"] = "shape_correspondence/nearest";
  result["version"] = 1;
  result["query"] = found.query.file;
  result["category"] = found.nearest.category;
  result["shapes"] = found.shapes.size();
  result["evaluations"] = found.nearest.evaluations;
  result["nearest"] = Json::array();
  for (const Near_shape& near : found.nearest.shapes) {
    const Collection::Shape& shape = found.shapes[near.shape];
    result["nearest"].push_back(
        {{"name", shape.name}, {"file", shape.file}, {"category", near.category}, {"distance", near.distance}});
    set_pairs(result["nearest"].back(), near.map, found.query, shape);
  }
  result["warnings"] = found.warnings;
  result.write(out);
}

void write_npy(std::ostream& out, const Eigen::Ref<const Eigen::MatrixXd>& matrix)
{
  const std::string magic("\x93NUMPY\x01\x00", 8);
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(matrix.rows()) + ", " +
                       std::to_string(matrix.cols()) + "), }";
  const std::size_t size = magic.size() + 2 + header.size() + 1;
  header.append((npy_alignment - size % npy_alignment) % npy_alignment, ' ');
  header += '\n';
  out << magic << char(header.size() & 255) << char(header.size() >> 8) << header;
  for_each_row(matrix, [&](Eigen::Index, const auto& row) {
    out.write(reinterpret_cast<const char*>(row.data()), std::streamsize(sizeof(double)) * row.size());
  });
}

void write_csv(std::ostream& out, const Eigen::Ref<const Eigen::MatrixXd>& matrix,
               const std::vector<std::string>& names)
{
  for (const std::string& name : names)
    out << ',' << quote_csv(name);
  out << "\r\n";
  for_each_row(matrix, [&](Eigen::Index i, const auto& row) {
    out << quote_csv(names[std::size_t(i)]);
    for (double number : row)
      out << ',' << internal::number_text(number);
    out << "\r\n";
  });
}

} // namespace CGAL::Shape_correspondence::IO
