// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_stream.h"
#include "io/system/input_file.h"
#include "io/system/run_program.h"

#include <csignal>
#include <cstring>
#include <sys/wait.h>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr std::chrono::seconds longest_import(120);

/// How the program that reads the model failed, as the predicate of a sentence; empty if it did not.
std::string ending(const Program_run& run)
{
  if (run.took_too_long) return "takes more than 120 seconds to read";
  if (WIFEXITED(run.status) && WEXITSTATUS(run.status) == out_of_memory_status) return "takes more than 2 GB of memory";
  if (WIFSIGNALED(run.status) && WTERMSIG(run.status) == SIGXCPU) return "takes more than 60 seconds of processor time";
  if (WIFSIGNALED(run.status)) return std::string("makes its reader crash (") + strsignal(WTERMSIG(run.status)) + ")";
  return run.status != 0 ? "makes its reader crash" : "";
}

} // namespace

Model_content import_parts(const std::string& file, const Reading_options& options)
{
  try {
    const std::string program = own_program("shape_correspondence_import", "SHAPE_CORRESPONDENCE_IMPORT");
    const Program_run run =
        run_program(program, {file, options.allow_outside_files ? "outside" : "inside"}, longest_import);
    if (const std::string how = ending(run); !how.empty())
      refuse("it " + how + ": it is damaged, or too large", remedy::save_as_other_format);
    std::string_view text = run.output;
    if (text.substr(0, import_mark.size()) != import_mark)
      throw Invalid_input("the program " + program + " is of another version; install the package anew");
    text.remove_prefix(import_mark.size());
    if (text.empty()) refuse("what its reader sends is damaged", remedy::install_again);
    if (text[0] == has_complaint) throw Invalid_input(std::string(text.substr(1)));
    Value_bytes bytes(text.substr(1));
    Model_content content;
    pass(bytes, content);
    return content;
  } catch (const Invalid_input& error) {
    refuse(file + ": " + error.what(), remedy::save_as_other_format);
  }
}

} // namespace CGAL::Shape_correspondence::IO
