// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/data_folder.h"
#include "cli/outputs.h"
#include "cli/run_report.h"
#include "io/system/atomic_file.h"
#include "io/system/quoting.h"

#include <boost/algorithm/string/join.hpp>

#include <filesystem>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence demo [FOLDER] [options]

Matches two chairs of different topology that come with the program, blends them, and writes the results into FOLDER,
a new folder (shape_correspondence_demo by default). It prints each command before it runs it.

)";

// A pair that the default method matches without an error: test_program scores it
constexpr const char* source_model = "chair_four_legged";
constexpr const char* target_model = "chair_swivel";

po::options_description all_options(Common_options& common) { return common_options(common); }

void run_shown(std::vector<std::string> words, const Common_options& common)
{
  if (!common.quiet)
    std::cout << "$ shape_correspondence " << IO::quote_terminal(boost::algorithm::join(words, " ")) << '\n';
  const Command& command = command_of(words[0]);
  words.erase(words.begin());
  words.insert(words.end(), {"--progress", common.progress});
  if (common.threads > 0) words.insert(words.end(), {"--threads", std::to_string(common.threads)});
  if (common.quiet) words.push_back("--quiet");
  command.run(words);
  if (!common.quiet) std::cout << '\n';
}

} // namespace

Command_help help_of_demo()
{
  static Common_options unused;
  return {help_text, all_options(unused)};
}

void run_demo(const std::vector<std::string>& arguments)
{
  Common_options common;
  const Arguments parsed = parse(arguments, all_options(common), 0, 1);
  if (parsed.help) return write_help(std::cout, command_of("demo"));
  check(common);
  const Run_report report(common);
  const fs::path folder = parsed.inputs.empty() ? "shape_correspondence_demo" : parsed.inputs[0];
  IO::check_new_folder(folder.string());
  const fs::path data = data_folder();
  fs::create_directories(folder);
  const auto output = [&](const char* name) { return (folder / name).string(); };
  const std::string source = (data / source_model).string(), target = (data / target_model).string();
  run_shown({"match", source, target, "--json", output("match.json"), "--html", output("match.html")}, common);
  run_shown({"blend", source, target, "--match", output("match.json"), "-o", output("blend.glb")}, common);
  if (!common.quiet)
    std::cout << "Written: " << IO::quote_terminal(output("match.html")) << " for any browser, "
              << IO::quote_terminal(output("blend.glb")) << ", an animation for any glTF viewer, and "
              << IO::quote_terminal(output("match.json")) << '\n';
}

} // namespace CGAL::Shape_correspondence::cli
