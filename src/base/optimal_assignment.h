// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Minimum-cost assignment of every row to a distinct column, by shortest augmenting paths (Jonker and Volgenant 1987),
/// O(rows² cols). Of equal costs, lower columns win. \return the column of every row \pre rows <= cols
inline std::vector<std::size_t> optimal_assignment(const Eigen::MatrixXd& cost)
{
  const int rows = int(cost.rows()), cols = int(cost.cols());
  std::vector<double> row_price(rows + 1, 0), col_price(cols + 1, 0);
  std::vector<int> row_of(cols + 1, 0), previous(cols + 1, 0); // numbers from 1 on; 0: no row or column
  std::vector<double> slack(cols + 1);
  std::vector<char> visited(cols + 1);
  for (int row = 1; row <= rows; ++row) {
    std::fill(slack.begin(), slack.end(), std::numeric_limits<double>::infinity());
    std::fill(visited.begin(), visited.end(), 0);
    int col = 0;
    row_of[0] = row;
    do {
      visited[col] = 1;
      double least = std::numeric_limits<double>::infinity();
      int next = 0;
      for (int j = 1; j <= cols; ++j) {
        if (visited[j]) continue;
        const double reduced = cost(row_of[col] - 1, j - 1) - row_price[row_of[col]] - col_price[j];
        if (reduced < slack[j]) slack[j] = reduced, previous[j] = col;
        if (slack[j] < least) least = slack[j], next = j;
      }
      for (int j = 0; j <= cols; ++j) {
        if (visited[j])
          row_price[row_of[j]] += least, col_price[j] -= least;
        else
          slack[j] -= least;
      }
      col = next;
    } while (row_of[col] != 0);
    for (; col != 0; col = previous[col])
      row_of[col] = row_of[previous[col]];
  }
  std::vector<std::size_t> col_of(rows);
  for (int j = 1; j <= cols; ++j)
    if (row_of[j] != 0) col_of[row_of[j] - 1] = std::size_t(j - 1);
  return col_of;
}

} // namespace CGAL::Shape_correspondence::internal
