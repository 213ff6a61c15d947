#pragma once

#include <functional>
#include <string_view>

namespace clapotis {

inline constexpr int exit_done = 0, exit_check_failed = 1, exit_usage = 2, exit_no_display = 3, exit_file = 4,
                     exit_diverged = 5, exit_interrupted = 130;

/// Runs a program; what it throws becomes one sentence on standard error, which starts with the program's
/// name, and an exit code.
int with_exit_code(const char* program_path, const std::function<int()>& program);

/// "name: sentence" on standard error.
void complain(std::string_view name, std::string_view sentence);

/// The last part of the path by which a program was called.
std::string_view program_name(const char* path);

/// Prints on standard output; throws FileError when that is full or closed.
void print_result(std::string_view text);

}  // namespace clapotis
