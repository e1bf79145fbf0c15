// The commands of the program `seesaw`: one file and one line each.
//
// Before it: a command line.  After it: core/scene reads the document, core/rbf fits it.
//
// To add a command, write cli/<name>.cpp, which defines
//
//     void add_<name>(CLI::App& program);
//
// and give it a line below, where the help text will have it. That function adds a subcommand with its
// options and a callback that does the work. A callback returns when all went well and throws seesaw::Error
// when not: the message goes to stderr, the exit status is 2 (main.cpp). What it has to say goes through
// print() of cli/output.h.
#pragma once

#include <CLI/CLI.hpp>

#define SEESAW_COMMANDS(command)                                                               \
  command(info) command(eval) command(contour) command(check) command(polygonize) command(fit) \
      command(blend) command(raytrace)

namespace seesaw {

#define SEESAW_DECLARE(name) void add_##name(CLI::App& program);
SEESAW_COMMANDS(SEESAW_DECLARE)
#undef SEESAW_DECLARE

}  // namespace seesaw
