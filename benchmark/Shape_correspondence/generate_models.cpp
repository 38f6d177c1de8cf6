// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the models of data/, or the shapes of the benchmark, each a folder of parts with labels.

#include "command_line.h"
#include "generator/benchmark/degrade.h"
#include "generator/benchmark/vehicles.h"
#include "generator/grammar/kinds.h"
#include "generator/models.h"
#include "generator/textures.h"
#include "generator/writer.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace gen = CGAL::Shape_correspondence::generator;
namespace fs = std::filesystem;
using namespace CGAL::Shape_correspondence::benchmark;

namespace {

constexpr int bad_input = 1, bad_usage = 2;

struct Options
{
  bool help = false, list = false, single_file = false, raw = false, textured = false, benchmark = false;
  bool gallery = false, degrades = false;
  std::size_t training = 0; // number of training shapes; 0: none
  gen::Degradation degradation;
  std::uint64_t seed = 1;
  std::string folder;
};

const char* const help_text =
    R"(Usage: generate_models [--single-file | --raw | --textured] OUTPUT_FOLDER
       generate_models --benchmark [--degrade WAYS] [--seed N] OUTPUT_FOLDER
       generate_models --training N [--seed N] OUTPUT_FOLDER
       generate_models --gallery OUTPUT_FOLDER
       generate_models [--benchmark | --training | --gallery] --list

Writes labelled models of man-made shapes; the same bytes every time.
  OUTPUT_FOLDER/NAME/parts/PART.obj  one closed mesh a part; metres, y up, front +z, left +x
  OUTPUT_FOLDER/NAME/labels.json     coarse and fine label of each part
  OUTPUT_FOLDER/NAME/structure.json  mid-lines and mid-surfaces, symmetry groups, contacts

  --single-file  write OUTPUT_FOLDER/NAME.obj instead, one `o` a part
  --raw          write OUTPUT_FOLDER/NAME.obj instead, z up, one `o` for all parts of a coarse label, as models from
                 catalogues often are
  --textured     write OUTPUT_FOLDER/NAME.obj instead, one `o` a part, with NAME.mtl and a texture on which seams and
                 flips show
  --benchmark    make the shapes that methods are compared on instead, fifteen of each of six categories, in
                 OUTPUT_FOLDER/CATEGORY/NAME. They are drawn by a grammar
  --training     make N shapes that roles are learned from instead, of ten categories of the same grammar, in
                 OUTPUT_FOLDER/CATEGORY/NAME. They have no structure.json
  --gallery      make boats and carts, three of each, in OUTPUT_FOLDER/CATEGORY/NAME
  --degrade      make them worse; WAYS are any of segmentation, open, gaps, noise, scale, rotation, with commas
                 in between: parts cut and joined, surfaces with holes, parts that do not meet, vertices off
                 their places, other proportions, turned about the up axis
  --seed         of what is drawn; 1 if not given
  --list         print the names of the models
  --help         print this
)";

gen::Degradation parsed_ways(const std::string& list)
{
  gen::Degradation ways;
  const std::pair<const char*, bool*> known[] = {{"segmentation", &ways.segmentation},
                                                 {"open", &ways.openings},
                                                 {"gaps", &ways.gaps},
                                                 {"noise", &ways.noise},
                                                 {"scale", &ways.scale},
                                                 {"rotation", &ways.rotation}};
  for (const std::string& word : words_of(list)) {
    const auto found = std::find_if(std::begin(known), std::end(known), [&](const auto& k) { return k.first == word; });
    if (found == std::end(known)) throw std::invalid_argument("unknown way to degrade '" + word + "'");
    *found->second = true;
  }
  return ways;
}

Options parsed(int argc, char** argv)
{
  Command_line line(argc, argv);
  Options options;
  while (!line.is_at_end()) {
    const std::string& word = line.word();
    if (word == "--help" || word == "-h")
      options.help = true;
    else if (word == "--list")
      options.list = true;
    else if (word == "--single-file")
      options.single_file = true;
    else if (word == "--raw")
      options.raw = true;
    else if (word == "--textured")
      options.textured = true;
    else if (word == "--benchmark")
      options.benchmark = true;
    else if (word == "--training")
      options.training = whole_number(line.value(), "a number of shapes");
    else if (word == "--gallery")
      options.gallery = true;
    else if (word == "--degrade") {
      options.degrades = true;
      options.degradation = parsed_ways(line.value());
    } else if (word == "--seed")
      options.seed = whole_number(line.value(), "a seed");
    else {
      refuse_option(word);
      if (!options.folder.empty()) throw std::invalid_argument("more than one output folder");
      options.folder = word;
    }
  }
  if (options.raw + options.single_file + options.textured > 1)
    throw std::invalid_argument("of --raw, --single-file and --textured, only one may be given");
  if (options.benchmark + (options.training > 0) + options.gallery > 1)
    throw std::invalid_argument("of --benchmark, --training and --gallery, only one may be given");
  if (options.degrades && !options.benchmark) throw std::invalid_argument("--degrade is of --benchmark");
  if (!options.help && !options.list && options.folder.empty()) throw std::invalid_argument("no output folder");
  return options;
}

void write(const fs::path& path, const std::string& content)
{
  fs::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  out << content;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + path.string());
}

std::vector<gen::Assembly> shapes(const Options& options)
{
  if (options.benchmark) return gen::compared_shapes(options.seed);
  if (options.training > 0) return gen::drawn_shapes(options.training, options.seed);
  std::vector<gen::Assembly> result;
  if (options.gallery) {
    result = gen::boats();
    for (gen::Assembly& cart : gen::carts())
      result.push_back(std::move(cart));
    return result;
  }
  for (const gen::Model& model : gen::models())
    result.push_back(model.make());
  return result;
}

gen::Files files_of(const gen::Assembly& shape, const Options& options)
{
  if (options.textured) return gen::textured_file(shape);
  return options.raw ? gen::raw_file(shape) : options.single_file ? gen::single_file(shape) : gen::folder_files(shape);
}

void write_models(const Options& options)
{
  std::uint64_t seed = options.seed << 32; // of degradation; far from the seeds that draw shapes
  for (gen::Assembly shape : shapes(options)) {
    if (options.degrades) shape = gen::degraded(std::move(shape), options.degradation, seed);
    seed += 100;
    const fs::path folder = options.benchmark || options.training > 0 || options.gallery
                                ? fs::path(options.folder) / shape.category
                                : fs::path(options.folder);
    for (const auto& [path, content] : files_of(shape, options))
      write(folder / path, content);
  }
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  try {
    options = parsed(argc, argv);
  } catch (const std::invalid_argument& error) {
    std::cerr << "generate_models: " << error.what() << " (see --help)\n";
    return bad_usage;
  }
  try {
    if (options.help)
      std::cout << help_text;
    else if (options.list)
      for (const gen::Assembly& shape : shapes(options))
        std::cout << shape.name << '\n';
    else
      write_models(options);
  } catch (const std::exception& error) {
    std::cerr << "generate_models: " << error.what() << '\n';
    return bad_input;
  }
}
