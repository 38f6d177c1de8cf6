// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "cli/load_shape.h"

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Greatest number of inputs of a command that takes any number.
constexpr std::size_t any_number = std::size_t(-1);

/// A command of the program, constructed for one run: its help, its options, and its work.
class Command
{
public:
  /// \param text usage, description and examples \param least, most limits of the number of inputs
  Command(const char* text, std::size_t least, std::size_t most) : text_(text), least_(least), most_(most) {}
  virtual ~Command() = default;

  const Option_table& options() const { return table; }
  /// Writes the help of this command. \param all whether to include rare options
  void write_help(std::ostream& out, bool all) const;

  /// Parses the arguments, checks them and does the work. \throw Usage_error, Invalid_input
  void run(const std::vector<std::string>& arguments);

protected:
  /// Checks combinations of options. \throw Usage_error
  virtual void check() {}
  /// The files to write and the files to read, which must differ. By default: the values of options marked as output;
  /// the values of options marked as input, and the inputs.
  virtual std::vector<std::string> output_files() const;
  virtual std::vector<std::string> input_files() const;
  virtual void work() = 0;

  /// Refuses options of part abstraction if all inputs are structural graphs. \throw Usage_error
  void refuse_abstraction_of_graphs() const;

  Option_table table;
  Common_options common;
  std::vector<std::string> inputs;

private:
  const char* text_;
  std::size_t least_, most_;
};

struct Command_entry
{
  std::string name, summary; ///< name, and description in one line
  std::unique_ptr<Command> (*make)();
};

/// All commands, in the order in which they are listed.
const std::vector<Command_entry>& commands();

/// The command of a name. \throw Usage_error if there is none; the message suggests the most similar name
std::unique_ptr<Command> command_of(const std::string& name);

/// Writes the help of the program.
void write_help(std::ostream& out);

// The commands; each is defined in its own source
std::unique_ptr<Command> parts_command();
std::unique_ptr<Command> graph_command();
std::unique_ptr<Command> match_command();
std::unique_ptr<Command> blend_command();
std::unique_ptr<Command> transfer_command();
std::unique_ptr<Command> collection_command();
std::unique_ptr<Command> evaluate_command();
std::unique_ptr<Command> roles_command();
std::unique_ptr<Command> label_command();
std::unique_ptr<Command> demo_command();
std::unique_ptr<Command> completion_command();
std::unique_ptr<Command> help_command();

class Pair_command : public Command
{
protected:
  explicit Pair_command(const char* text) : Command(text, 2, 2) {}

  /// Adds the option for reading the correspondence from a file.
  void add_result_option(Option_table::Group& add);
  /// Adds the options for the match and the shapes, after those of the specific command.
  void add_shared_options();

  void check() override;

  /// Loads the shapes, and resolves the parts named by options.
  void load();
  /// The correspondence: read from `result`, or computed.
  Correspondence correspondence() const;

  const Loaded_shape& source() const { return shapes[0]; }
  const Loaded_shape& target() const { return shapes[1]; }

  Match_options match;
  std::string result; ///< result file of `match --json`; empty: the correspondence is computed
  Search_options search;
  std::vector<Loaded_shape> shapes;
  std::vector<std::string> warnings; ///< warnings about the shapes and examples
};

} // namespace CGAL::Shape_correspondence::cli
