// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/run.h"
#include "io/system/input_file.h"
#include "io/system/operating_system.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/version.h>

#include <CGAL/assertions_behaviour.h>

#include <filesystem>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

enum Exit_status { done = 0, unusable_input = 1, bad_usage = 2 };

int complain(const std::string& message, Exit_status status)
{
  std::cerr << "shape_correspondence: " << IO::quote_terminal(in_program_words(message), true) << '\n';
  return status;
}

int flushed()
{
  std::cout.flush();
  return std::cout ? done
                   : complain(std::string("standard output: it cannot be written; ") + IO::remedy::write_elsewhere,
                              unusable_input);
}

int run_command(const std::string& name, const std::vector<std::string>& arguments)
{
  std::unique_ptr<Command> command;
  try {
    command = command_of(name);
    command->run(arguments);
    return flushed();
  } catch (const Usage_error& error) {
    const std::string what = error.what(), end = what.back() == '?' ? " Try" : "; try";
    if (!command) return complain(what + end + " 'shape_correspondence --help'", bad_usage);
    return complain(name + ": " + what + end + " 'shape_correspondence " + name + " --help'", bad_usage);
  } catch (const Invalid_input& error) {
    return complain(error.what(), unusable_input);
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string path = error.path1().string();
    return complain((path.empty() ? "a folder" : path) + ": it cannot be used (" + error.code().message() + "); " +
                        IO::remedy::check_permissions,
                    unusable_input);
  } catch (const std::bad_alloc&) {
    return complain(std::string("there is not enough memory for this input; ") + IO::remedy::make_smaller,
                    unusable_input);
  } catch (const std::exception& error) {
    return complain("unexpected error: " + std::string(error.what()) +
                        "; this is a mistake of the program: please report it, with the command and its inputs",
                    unusable_input);
  }
}

int run(const std::vector<std::string>& arguments)
{
  if (arguments.empty()) {
    write_help(std::cerr);
    return bad_usage;
  }
  if (arguments[0] == "--help" || arguments[0] == "-h")
    write_help(std::cout);
  else if (arguments[0] == "--version")
    std::cout << "shape_correspondence " CGAL_SHAPE_CORRESPONDENCE_VERSION "\n";
  else
    return run_command(arguments[0], {arguments.begin() + 1, arguments.end()});
  return flushed();
}

} // namespace
} // namespace CGAL::Shape_correspondence::cli

int main(int argc, char* argv[])
{
  namespace SC = CGAL::Shape_correspondence;
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}); // the exceptions say enough
  return SC::cli::run(SC::IO::start_program(argc, argv));
}
