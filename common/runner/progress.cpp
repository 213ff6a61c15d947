#include "common/runner/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "common/runner/stopwatch.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr double pause = 0.1;         // between two drawings [s]
constexpr double before_first = 0.3;  // a run that is over sooner shows no bar [s]
constexpr int cells = 30;

bool has_variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

bool can_move_cursor() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::min(seconds + 0.5, 3.6e6));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace

Progress::Progress(bool wanted)
    : wanted_(wanted && can_move_cursor()), coloured_(!has_variable("NO_COLOR")), start_(wall_seconds()) {}

void Progress::show(double share, double time) { show(share, fmt::format("t = {:.3g} s", time)); }

void Progress::show(double share, std::string_view what) {
  const double now = wall_seconds();
  if (!wanted_ || now - start_ < before_first || now - last_ < pause) return;
  last_ = now;
  drawn_ = true;
  share = std::clamp(share, 0.0, 1.0);
  const auto done = static_cast<std::size_t>(share * cells);
  const auto left = share > 0 ? duration((now - start_) * (1 - share) / share) : "?";
  const auto text = say(words().progress, fmt::arg("percent", static_cast<int>(100 * share)),
                        fmt::arg("what", what), fmt::arg("left", left));
  const std::string full(done, '#'), rest(cells - done, '.');
  fmt::print(stderr, "\r[{}{}{}{}] {}\033[K", coloured_ ? "\033[32m" : "", full, coloured_ ? "\033[0m" : "",
             rest, text);
  std::fflush(stderr);
}

Progress::~Progress() {
  if (!drawn_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

}  // namespace clapotis
