#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace clapotis::testing {

/// A folder of its own for a test, removed at its end.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// How a program ended and what it said.
struct Ended {
  int code;  ///< 128 + the signal's number when a signal ended it
  std::string out, err;
};

/// How to start a program besides its arguments.
struct Start {
  std::map<std::string, std::string> environment =
      {};                          ///< besides ours, without CLAPOTIS_* and what names a language
  std::filesystem::path out = {};  ///< where standard output goes instead, for example /dev/full
  std::size_t largest_file = 0;    ///< bytes; 0 for no limit
};

/// A program that runs in the scratch folder.
class Process {
 public:
  Process(const Scratch& scratch, const std::string& program, const std::vector<std::string>& arguments,
          const Start& start = {});
  void send(int signal) const;
  Ended wait();

 private:
  const Scratch& scratch_;
  int id_;
};

Ended run(const Scratch& scratch, const std::string& program, const std::vector<std::string>& arguments,
          const Start& start = {});

std::string read(const std::filesystem::path& file);
void write(const std::filesystem::path& file, const std::string& text);

}  // namespace clapotis::testing
