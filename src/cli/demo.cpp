// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "io/system/atomic_file.h"
#include "io/system/operating_system.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace fs = std::filesystem;

const char* const demo_help =
    R"(Usage: shape_correspondence demo [FOLDER] [options]

Matches and blends two chairs that come with the program. It prints each command before it runs it, and writes the results
into FOLDER, shape_correspondence_demo by default. FOLDER must be new, or that of an earlier demo.

)";

// A pair that the default method matches without an error, which test_program checks
constexpr const char* source_model = "chair_four_legged";
constexpr const char* target_model = "chair_swivel";

/// The folder of the models that come with the program: beside it, in the installation (found from the program's path),
/// or in the source tree. \throw Invalid_input if there is none
std::string data_folder()
{
  std::error_code error;
  const fs::path program = IO::program_file().parent_path();
  const fs::path installed = program.parent_path() / SHAPE_CORRESPONDENCE_INSTALLED_DATA;
  for (const fs::path& folder : {program / "data", installed, fs::path(SHAPE_CORRESPONDENCE_SOURCE_DATA)})
    if (fs::is_directory(folder / source_model, error)) return folder.string();
  throw Invalid_input(installed.string() + ": the models that come with the program are not there; install it again");
}

// Output files of the demo
constexpr const char *match_json = "match.json", *match_html = "match.html", *blend_html = "blend.html",
                     *blend_glb = "blend.glb";

/// Whether a folder contains only files of an earlier demo.
bool is_of_demo(const fs::path& folder)
{
  const std::vector<std::string> files{match_json, match_html, blend_html, blend_glb};
  if (!fs::is_directory(folder)) return false;
  const fs::directory_iterator entries(folder);
  return std::all_of(begin(entries), end(entries), [&](const fs::directory_entry& entry) {
    return entry.is_regular_file() &&
           std::find(files.begin(), files.end(), entry.path().filename().string()) != files.end();
  });
}

class Demo_command : public Command
{
public:
  Demo_command() : Command(demo_help, 0, 1) { add_common_options(table, common); }

private:
  void run_shown(const std::string& name, std::vector<std::string> words, bool is_quiet = false) const
  {
    if (!common.quiet)
      std::cout << "$ shape_correspondence " << IO::quote_terminal(name + ' ' + boost::algorithm::join(words, " "))
                << '\n';
    words.insert(words.end(), {"--progress", common.progress});
    if (common.threads > 0) words.insert(words.end(), {"--threads", std::to_string(common.threads)});
    if (common.quiet || is_quiet) words.push_back("--quiet");
    command_of(name)->run(words);
    if (!common.quiet) std::cout << '\n';
  }

  void work() override
  {
    const fs::path folder = inputs.empty() ? "shape_correspondence_demo" : inputs[0];
    if (!is_of_demo(folder)) IO::check_new_folder(folder.string());
    const fs::path data = data_folder();
    fs::create_directories(folder);
    const auto output = [&](const char* name) { return (folder / name).string(); };
    const std::string source = (data / source_model).string(), target = (data / target_model).string();
    run_shown("match", {source, target, "-o", output(match_html), "-o", output(match_json)});
    for (const char* blend : {blend_html, blend_glb})
      run_shown("blend", {source, target, "--match", output(match_json), "-o", output(blend)}, /* is_quiet = */ true);
    if (!common.quiet)
      std::cout << "Open " << IO::quote_terminal(output(match_html)) << " and "
                << IO::quote_terminal(output(blend_html))
                << " in a browser.\nAlso written: " << IO::quote_terminal(output(blend_glb))
                << ", the blend as an animation for any glTF viewer, and " << IO::quote_terminal(output(match_json))
                << ", the match as data.\n";
  }
};

} // namespace

std::unique_ptr<Command> demo_command() { return std::make_unique<Demo_command>(); }

} // namespace CGAL::Shape_correspondence::cli
