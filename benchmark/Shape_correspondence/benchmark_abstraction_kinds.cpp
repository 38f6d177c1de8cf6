// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fits the thresholds by which mean curvature flow tells sheets from curves (`Meso_thresholds`), and judges them on the
// category left out: benchmark_abstraction_kinds SHAPE_FOLDER... Every folder holds parts/, labels.json, and a
// structure.json that states the curves and sheets of the parts; `generate_models --benchmark` makes them.

#include "abstraction/Solid_abstractor.h"
#include "abstraction/meso_kind.h"
#include "abstraction/skeletonize.h"
#include "abstraction/surface_samples.h"
#include "abstraction_error.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace SC = CGAL::Shape_correspondence;
using namespace SC::internal;

namespace {

/// A part whose kind is stated.
struct Known_part
{
  std::string category;
  bool is_sheet = false;
  Meso_measures measures;
  bool is_measured = false; ///< else the flow fails, and thresholds change nothing
};

/// Measures the meso-skeleton of a part as `Mean_curvature_abstraction` does.
class Meso_measurer : public Solid_abstractor
{
public:
  Meso_measurer(const SC::Shape_part& part, const SC::Abstraction_options& options, Known_part& known)
      : Solid_abstractor(part, options), known_(known)
  {}

private:
  void find_geometry(const SC::Part_mesh& solid) override
  {
    Stepwise_flow flow(solid, options().maximum_iterations, deadline());
    flow.set_weights(slow_flow);
    flow.run_to_volume(options().stop_volume);
    known_.measures = meso_measures(flow.meso_skeleton(), flow.area_kept(), 2 * volume() / surface_area(solid));
    known_.is_measured = true;
  }

  Known_part& known_;
};

using Parts = std::vector<Known_part>;

void measure(const std::string& folder, Parts& parts)
{
  std::ifstream labels(folder + "/labels.json");
  const std::string category = nlohmann::json::parse(labels)["category"];
  const std::map<std::string, SC::Part_abstraction> stated = SC::benchmark::stated_abstractions(folder);
  const SC::Segmented_shape shape = SC::IO::read_segmented_shape(folder + "/parts");
  for (const SC::Shape_part& part : shape.parts()) {
    const auto found = stated.find(part.name);
    if (found == stated.end() || found->second.is_closed_curve()) continue; // rings are known by their skeletons
    parts.push_back({category, found->second.is_sheet(), {}, false});
    Meso_measurer(part, {}, parts.back()).run();
  }
}

/// How many parts of a category, or of all others, get their kind.
std::size_t right(const Parts& parts, const Meso_thresholds& thresholds, const std::string& category, bool is_in)
{
  std::size_t count = 0;
  for (const Known_part& part : parts)
    if ((part.category == category) == is_in)
      count += part.is_measured && (meso_kind(part.measures, thresholds) == Meso_kind::SHEET) == part.is_sheet;
  return count;
}

/// The best thresholds for the parts of all categories but one; of equal ones those nearest to the present ones.
Meso_thresholds fitted(const Parts& parts, const std::string& left_out)
{
  const Meso_thresholds present;
  Meso_thresholds best;
  std::tuple<std::size_t, double> best_score{0, 0};
  for (double area = 0.2; area < 0.6; area += 0.02)
    for (double thin_area = 0.08; thin_area < 0.3; thin_area += 0.02)
      for (double width = 2; width <= 10; width += 0.5) {
        const Meso_thresholds tried{area, thin_area, width};
        const double change = std::abs(std::log(area / present.sheet_area)) +
                              std::abs(std::log(thin_area / present.thin_sheet_area)) +
                              std::abs(std::log(width / present.thin_sheet_width));
        const std::tuple<std::size_t, double> score{right(parts, tried, left_out, false), -change};
        if (score <= best_score) continue;
        best_score = score;
        best = tried;
      }
  return best;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2) {
    std::fprintf(stderr, "usage: benchmark_abstraction_kinds SHAPE_FOLDER...\n");
    return 2;
  }
  try {
    Parts parts;
    for (int i = 1; i < argc; ++i)
      measure(argv[i], parts);
    std::map<std::string, std::size_t> sizes;
    for (const Known_part& part : parts)
      ++sizes[part.category];
    std::printf("| category left out | parts | right with the present thresholds | right with those of the others | "
                "area | thin area | width |\n|---|---|---|---|---|---|---|\n");
    std::size_t present_right = 0, fitted_right = 0;
    for (const auto& [category, size] : sizes) {
      const Meso_thresholds thresholds = fitted(parts, category);
      const std::size_t present = right(parts, {}, category, true), others = right(parts, thresholds, category, true);
      std::printf("| %s | %zu | %zu | %zu | %.2f | %.2f | %.1f |\n", category.c_str(), size, present, others,
                  thresholds.sheet_area, thresholds.thin_sheet_area, thresholds.thin_sheet_width);
      present_right += present;
      fitted_right += others;
    }
    const Meso_thresholds all = fitted(parts, "");
    std::printf("| none | %zu | %zu | %zu | %.2f | %.2f | %.1f |\n", parts.size(), present_right,
                right(parts, all, "", false), all.sheet_area, all.thin_sheet_area, all.thin_sheet_width);
    std::printf("\nright on the category left out: %zu of %zu\n", fitted_right, parts.size());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "benchmark_abstraction_kinds: %s\n", error.what());
    return 1;
  }
}
