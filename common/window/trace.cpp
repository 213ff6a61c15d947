#include "common/window/trace.hpp"

#include <cstdlib>
#include <utility>

namespace clapotis {

Trace::Trace() {
  if (const char* path = std::getenv("CLAPOTIS_TRACE"); path != nullptr && *path != '\0')
    file_.open(path, std::ios::app);
}

Trace::~Trace() {
  flush();
  flush();
}

void Trace::say(std::string line) {
  if (active()) said_.push_back(std::move(line));
}

void Trace::place(const std::string& line) {
  if (active()) file_ << line << '\n';
}

void Trace::flush() {
  if (!active()) return;
  for (const auto& line : settled_) file_ << line << '\n';
  if (!settled_.empty()) file_ << '\n';
  file_.flush();
  settled_ = std::exchange(said_, {});
}

}  // namespace clapotis
