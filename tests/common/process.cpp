#include "tests/common/process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace clapotis::testing {
namespace {

namespace fs = std::filesystem;

constexpr const char *out_name = "standard_output", *err_name = "standard_error";

/// What a test does not say must not depend on the language of this machine.
bool speaks(const std::string& variable) {
  return variable == "LC_ALL" || variable == "LC_MESSAGES" || variable == "LANG";
}

std::vector<std::string> environment_of(const Start& start) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry, variable = text.substr(0, text.find('='));
    if (!text.starts_with("CLAPOTIS_") && !speaks(variable) && !start.environment.contains(variable))
      all.push_back(text);
  }
  for (const auto& [name, value] : start.environment) all.push_back(name + '=' + value);
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (auto& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

void redirect(const fs::path& file, int to) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, to) < 0) _exit(126);
}

}  // namespace

Scratch::Scratch() {
  auto name = (fs::temp_directory_path() / "clapotis-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
  path_ = name;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Process::Process(const Scratch& scratch, const std::string& program,
                 const std::vector<std::string>& arguments, const Start& start)
    : scratch_(scratch) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  auto environment = environment_of(start);
  const auto argv = pointers(words), envp = pointers(environment);
  const auto out = start.out.empty() ? scratch / out_name : start.out;
  id_ = fork();
  if (id_ < 0) throw std::runtime_error("no process");
  if (id_ > 0) return;
  redirect(out, STDOUT_FILENO);
  redirect(scratch / err_name, STDERR_FILENO);
  const rlimit limit{start.largest_file, start.largest_file};
  if (start.largest_file > 0 && setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(126);
  if (chdir(scratch.path().c_str()) != 0) _exit(126);
  execve(program.c_str(), argv.data(), envp.data());
  _exit(127);
}

void Process::send(int signal) const { kill(id_, signal); }

Ended Process::wait() {
  int status = 0;
  if (waitpid(id_, &status, 0) != id_) throw std::runtime_error("no such process");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read(scratch_ / out_name),
          read(scratch_ / err_name)};
}

Ended run(const Scratch& scratch, const std::string& program, const std::vector<std::string>& arguments,
          const Start& start) {
  return Process(scratch, program, arguments, start).wait();
}

std::string read(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

}  // namespace clapotis::testing
