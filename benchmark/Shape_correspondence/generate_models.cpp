// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the models of data/, each a folder of parts with labels.

#include "generator/models.h"
#include "generator/writer.h"

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace gen = CGAL::Shape_correspondence::generator;
namespace fs = std::filesystem;

namespace {

constexpr int bad_input = 1, bad_usage = 2;

struct Options
{
  bool help = false, list = false, single_file = false;
  std::string folder;
};

void print_help(std::ostream& out)
{
  out << "Usage: generate_models [--single-file] OUTPUT_FOLDER\n"
         "       generate_models --list\n"
         "\n"
         "Writes labelled models of man-made shapes; the same bytes every time.\n"
         "  OUTPUT_FOLDER/NAME/parts/PART.obj  one closed mesh a part; metres, y up, front +z, left +x\n"
         "  OUTPUT_FOLDER/NAME/labels.json     coarse and fine label of each part\n"
         "  OUTPUT_FOLDER/NAME/structure.json  mid-lines and mid-surfaces, symmetry groups, contacts\n"
         "\n"
         "  --single-file  write OUTPUT_FOLDER/NAME.obj instead, one `o` a part\n"
         "  --list         print the names of the models\n"
         "  --help         print this\n";
}

Options parsed(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--help" || argument == "-h")
      options.help = true;
    else if (argument == "--list")
      options.list = true;
    else if (argument == "--single-file")
      options.single_file = true;
    else if (argument.empty() || argument[0] == '-')
      throw std::invalid_argument("unknown option '" + argument + "'");
    else if (!options.folder.empty())
      throw std::invalid_argument("more than one output folder");
    else
      options.folder = argument;
  }
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

void write_models(const Options& options)
{
  for (const gen::Model& model : gen::models()) {
    const gen::Assembly shape = model.make();
    for (const auto& [path, content] : options.single_file ? gen::single_file(shape) : gen::folder_files(shape))
      write(fs::path(options.folder) / path, content);
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
      print_help(std::cout);
    else if (options.list)
      for (const gen::Model& model : gen::models())
        std::cout << model.name << '\n';
    else
      write_models(options);
  } catch (const std::exception& error) {
    std::cerr << "generate_models: " << error.what() << '\n';
    return bad_input;
  }
}
