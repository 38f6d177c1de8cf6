// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/number_text.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/IO/matrix_files.h>

#include <algorithm>
#include <ostream>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr std::size_t npy_alignment = 64;

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "files of doubles are written as they are in memory");

constexpr Eigen::Index rows_at_a_time = 512; // number of entries of a column that fill a page of a file

/// Calls `take` with every row. Columns are contiguous, so that rows are read in blocks.
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
