#pragma once

namespace texbrdf::cli {

/// The whole program: reads the arguments, runs one subcommand, and gives what to exit with.
int run_command_line(int argc, const char* const* argv);

}  // namespace texbrdf::cli
