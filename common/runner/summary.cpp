#include "common/runner/summary.hpp"

#include <cmath>

#include "common/runner/ticks.hpp"
#include "common/runner/units.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

std::string short_number(double value) { return fmt::format("{:.4g}", value); }

/// 1.3e6 is 1.3 M.
std::string rate(double per_second) {
  if (per_second >= 1e6) return fmt::format("{:.3g} M", per_second / 1e6);
  if (per_second >= 1e3) return fmt::format("{:.3g} k", per_second / 1e3);
  return fmt::format("{:.3g}", per_second);
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.3g} us", seconds * 1e6);
  if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} s", seconds);
}

std::string reason_in_words(StopReason reason) {
  const auto& w = words();
  switch (reason) {
    case StopReason::interrupted:
      return std::string(w.stopped_interrupted);
    case StopReason::diverged:
      return std::string(w.stopped_diverged);
    default:
      return std::string(w.stopped_done);
  }
}

std::string energy_line(const Simulation& s, const RunResult& result) {
  const double drift = result.end.total() - result.start.total();
  const double scale = std::abs(result.start.total()) > 0 ? std::abs(result.start.total()) : 1;
  return say(words().summary_energy, fmt::arg("start", short_number(result.start.mechanical())),
             fmt::arg("end", short_number(result.end.mechanical())), fmt::arg("unit", short_energy_unit(s)),
             fmt::arg("drift", fmt::format("{:.2e}", drift / scale)));
}

std::string error_line(const Simulation& s, const RunResult& result) {
  const auto& reference = *s.setup().reference;
  const double error = s.error();
  return say(words().summary_error, fmt::arg("measure", called(reference.measure)),
             fmt::arg("unit", reference.unit.empty() ? "" : " " + reference.unit),
             fmt::arg("reference", called(reference.name)),
             fmt::arg("largest", fmt::format("{:.3e}", result.largest_error)),
             fmt::arg("error", std::isfinite(error) ? fmt::format("{:.3e}", error) : "-"));
}

}  // namespace

std::string summary(const std::filesystem::path& folder, Simulation& s, const RunResult& result) {
  const auto& w = words();
  auto text =
      say(w.summary_run, fmt::arg("folder", folder.string()),
          fmt::arg("reason", reason_in_words(result.reason)), fmt::arg("time", short_number(s.time())),
          fmt::arg("steps", s.steps()), fmt::arg("integrator", s.integrator()),
          fmt::arg("dt", short_number(s.dt())), fmt::arg("particles", s.particles().size()));
  if (s.steps() > result.first_step && result.cpu_seconds > 0) {
    const auto steps = static_cast<double>(s.steps() - result.first_step);
    const auto updates = steps * static_cast<double>(s.particles().size());
    text += say(w.summary_cost, fmt::arg("cpu", duration(result.cpu_seconds)),
                fmt::arg("step", duration(result.cpu_seconds / steps)),
                fmt::arg("rate", rate(updates / result.cpu_seconds)),
                fmt::arg("speed", two_digits((s.time() - result.first_time) / result.cpu_seconds)));
  }
  text += energy_line(s, result);
  if (s.setup().reference) text += error_line(s, result);
  if (!result.saved.file.empty())
    text += say(w.summary_saved, fmt::arg("file", result.saved.file),
                fmt::arg("time", short_number(result.saved.time)), fmt::arg("step", result.saved.steps));
  for (const auto& warning : result.warnings) text += say(w.summary_warning, fmt::arg("warning", warning));
  return text;
}

}  // namespace clapotis
