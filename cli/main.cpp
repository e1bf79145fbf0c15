// The program `seesaw`: takes the command line apart, runs one command, turns every failure into a sentence.
//
// Exit status: 0 when all went well, 2 for every error.
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/output.h"
#include "core/base/error.h"

namespace seesaw {

namespace {

void add_commands(CLI::App& program) {
#define SEESAW_ADD(name) add_##name(program);
  SEESAW_COMMANDS(SEESAW_ADD)
#undef SEESAW_ADD
}

// Asked before the parser is: it would call an unknown command one argument too many.
void refuse_unknown_command(const CLI::App& program, const std::string& word) {
  if (word.substr(0, 1) == "-") return;
  std::string names;
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_name() == word) return;
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw Error("unknown command \"" + word + "\"; the commands are " + names);
}

// The help of the command that was asked about, or else of the program.
std::string help_of(const CLI::App& program) {
  const std::vector<CLI::App*> given = program.get_subcommands();
  return given.empty() ? program.help() : given.front()->help(program.get_name());
}

void run(int argc, char** argv) {
  CLI::App program("Interpolating implicit curves and surfaces (Turk & O'Brien 2002) from the command line.",
                   "seesaw");
  program.set_version_flag("--version", "seesaw " SEESAW_VERSION, "Print the version and exit");
  program.require_subcommand(0, 1);
  program.get_formatter()->label("SUBCOMMAND", "COMMAND");
  add_commands(program);
  for (CLI::App* command : program.get_subcommands({})) command->group("Commands");
  program.footer(
      "A SCENE is a document in JSON, as the editors save it and figures/scenes has many.\n"
      "`seesaw COMMAND --help` says more about a command.");
  try {
    if (argc > 1) refuse_unknown_command(program, argv[1]);
    program.parse(argc, argv);
    if (program.get_subcommands().empty()) print(program.help());
  } catch (const CLI::CallForHelp&) {
    print(help_of(program));
  } catch (const CLI::CallForVersion& version) {
    print(version.what() + std::string("\n"));
  } catch (const CLI::ParseError& error) {
    const std::vector<CLI::App*> given = program.get_subcommands();
    const std::string about = given.empty() ? "" : " " + given.front()->get_name();
    throw Error(std::string(error.what()) + "\nsee: seesaw" + about + " --help");
  }
}

}  // namespace

}  // namespace seesaw

int main(int argc, char** argv) {
  // A reader that leaves early (`seesaw eval ... | head`) is no reason to die by a signal.
  std::signal(SIGPIPE, SIG_IGN);
  try {
    seesaw::run(argc, argv);
    return 0;
  } catch (const seesaw::ReaderLeft&) {
    return 0;
  } catch (const std::bad_alloc&) {
    std::cerr << "seesaw: not enough memory for this" << std::endl;
  } catch (const std::exception& error) {
    std::cerr << "seesaw: " << error.what() << std::endl;
  }
  return 2;
}
