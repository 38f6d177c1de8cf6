// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/estimate_up.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <functional>
#include <string>

namespace CGAL::Shape_correspondence::IO {

using Tell = std::function<void(const std::string&)>;

/// The result of `work` on a model (parts or upright axes): from the folder `cache`, or else computed and kept there.
/// \tparam Answer `Part_split`, `Up_estimate`, `std::array<Up_estimate, 2>` or `std::vector<Point>`
/// \param question identifies model and work \param warn receives a warning if the kept answer is damaged
template <typename Answer>
Answer kept_answer(const std::string& cache, const std::string& question, const std::function<Answer()>& work,
                   const Tell& warn);

} // namespace CGAL::Shape_correspondence::IO
