// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Options of the command line, and the files that they name.
#pragma once

#include "../command_line.h"
#include "dataset.h"

#include <iostream>

namespace CGAL::Shape_correspondence::experiments {

struct Options
{
  std::string experiment, out = ".", cache;
  std::vector<std::string> data, categories;
  std::size_t pairs = 0; ///< largest number of pairs of a category; 0: all
};

inline Dataset load(const std::string& folder, const Options& options)
{
  Dataset dataset = load_dataset(folder, options.cache, options.categories);
  for (Category& category : dataset) {
    if (options.pairs == 0 || category.pairs.size() <= options.pairs) continue;
    std::vector<peers::Shape_pair> some;
    for (std::size_t k = 0; k < options.pairs; ++k)
      some.push_back(category.pairs[k * category.pairs.size() / options.pairs]);
    category.pairs = some;
  }
  return dataset;
}

/// The categories of DATA, and those of FURTHER_DATA after them.
inline Dataset with_further_data(const Dataset& of_data, const Options& options)
{
  Dataset dataset = of_data;
  for (std::size_t i = 1; i < options.data.size(); ++i)
    for (const Category& category : load(options.data[i], options))
      dataset.push_back(category);
  return dataset;
}

inline std::ofstream picture(const Options& options, const std::string& name)
{
  fs::create_directories(options.out);
  const std::string path = (fs::path(options.out) / name).string();
  std::ofstream out(path, std::ios::binary);
  if (!out) throw Invalid_input(path + ": it cannot be written");
  std::cout << '\n' << "Picture: " << name << "\n\n";
  return out;
}

inline Options parsed(int argc, char** argv)
{
  benchmark::Command_line line(argc, argv);
  Options options;
  while (!line.is_at_end()) {
    const std::string& word = line.word();
    if (word == "--out")
      options.out = line.value();
    else if (word == "--cache")
      options.cache = line.value();
    else if (word == "--category")
      options.categories = benchmark::words_of(line.value());
    else if (word == "--pairs")
      options.pairs = benchmark::whole_number(line.value(), "--pairs");
    else {
      benchmark::refuse_option(word);
      if (options.experiment.empty())
        options.experiment = word;
      else
        options.data.push_back(word);
    }
  }
  if (options.data.empty()) throw std::invalid_argument("no experiment, or no data");
  return options;
}

} // namespace CGAL::Shape_correspondence::experiments
