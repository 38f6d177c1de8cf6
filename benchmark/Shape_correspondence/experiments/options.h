// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is asked on the command line, and what it opens.
#ifndef CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_OPTIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_OPTIONS_H

#include "dataset.h"

#include <iostream>
#include <sstream>

namespace CGAL {
namespace Shape_correspondence {
namespace experiments {

struct Options
{
  std::string experiment, out = ".", cache;
  std::vector<std::string> data, categories;
  std::size_t pairs = 0; ///< 0: all
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

inline std::ofstream picture(const Options& options, const std::string& name)
{
  fs::create_directories(options.out);
  const std::string path = (fs::path(options.out) / name).string();
  std::ofstream out(path, std::ios::binary);
  if (!out) throw Invalid_input(path + ": it cannot be written");
  std::cout << '\n' << "Picture: " << name << '\n';
  return out;
}

inline std::vector<std::string> words(const std::string& list)
{
  std::vector<std::string> result;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');)
    result.push_back(word);
  return result;
}

inline Options parsed(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const auto value = [&] {
      if (++i == argc) throw std::invalid_argument(argument + " needs a value");
      return std::string(argv[i]);
    };
    if (argument == "--out")
      options.out = value();
    else if (argument == "--cache")
      options.cache = value();
    else if (argument == "--category")
      options.categories = words(value());
    else if (argument == "--pairs") {
      const std::string number = value();
      if (number.empty() || number.size() > 9 || number.find_first_not_of("0123456789") != std::string::npos)
        throw std::invalid_argument("--pairs is a number, not '" + number + "'");
      options.pairs = std::stoul(number);
    } else if (argument.empty() || argument[0] == '-')
      throw std::invalid_argument("unknown option '" + argument + "'");
    else if (options.experiment.empty())
      options.experiment = argument;
    else
      options.data.push_back(argument);
  }
  if (options.data.empty()) throw std::invalid_argument("no experiment, or no data");
  return options;
}

} // namespace experiments
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_OPTIONS_H
