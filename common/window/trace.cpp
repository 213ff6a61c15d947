#include "common/window/trace.hpp"

#include <cstdlib>
#include <utility>

namespace clapotis {

Trace::Trace() {
  if (const char* path = std::getenv("CLAPOTIS_TRACE"); path && *path) file_.open(path, std::ios::app);
}

void Trace::say(std::string line) {
  if (active()) lines_.push_back(std::move(line));
}

void Trace::flush() {
  if (lines_.empty()) return;
  for (const auto& line : lines_) file_ << line << '\n';
  file_.flush();
  lines_.clear();
}

}  // namespace clapotis
