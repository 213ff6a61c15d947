#include "common/runner/exit_code.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <new>
#include <string>

#include "common/runner/atomic_file.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {

std::string_view program_name(const char* path) {
  const std::string_view whole = path == nullptr ? "clapotis" : path;
  return whole.substr(whole.rfind('/') + 1);
}

void complain(std::string_view name, std::string_view sentence) {
  const auto line = std::string(name) + ": " + std::string(sentence) + "\n";
  std::fputs(line.c_str(), stderr);
}

void print_result(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0)
    refuse_file(words().cannot_write, std::string(words().standard_output), errno);
}

int with_exit_code(const char* program_path, const std::function<int()>& program) {
  std::signal(SIGXFSZ,
              SIG_IGN);  // a file that grows too large is an error of `write`, not the end of the program
  const auto fail = [&](std::string_view sentence, int code) {
    complain(program_name(program_path), sentence);
    return code;
  };
  try {
    return program();
  } catch (const BadInput& error) {
    return fail(error.what(), exit_usage);
  } catch (const FileError& error) {
    return fail(error.what(), exit_file);
  } catch (const Diverged& error) {
    return fail(error.what(), exit_diverged);
  } catch (const std::bad_alloc&) {
    return fail(words().no_memory, exit_usage);
  } catch (const std::exception& error) {
    return fail(say(words().own_fault, fmt::arg("what", error.what())), exit_check_failed);
  }
}

}  // namespace clapotis
