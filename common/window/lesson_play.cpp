#include "common/window/lesson_play.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clapotis {
namespace {

constexpr double lasts = 6;  // s that a run takes, where the machine keeps up

/// In powers of two, as the speed is.
int octaves_to(double speed, const Session& session) {
  return static_cast<int>(std::lround(std::log2(speed / session.speed())));
}

bool same(const Overrides& left, const Overrides& right) {
  return std::equal(left.begin(), left.end(), right.begin(), right.end(), [](const auto& a, const auto& b) {
    return a.first == b.first && a.second.text == b.second.text;
  });
}

}  // namespace

LessonPlay::LessonPlay(const Stage& stage) : stage_(stage), exercises_(lesson_of(stage.name)) {
  for (const auto& exercise : exercises_)
    pages_.push_back({.findings = Findings(exercise),
                      .progress = std::vector<Progress>(exercise.runs.size(), Progress::none)});
}

void LessonPlay::turn(int pages) {
  const auto last = static_cast<std::ptrdiff_t>(count()) - 1;
  place_ = static_cast<std::size_t>(
      std::clamp(static_cast<std::ptrdiff_t>(place_) + pages, std::ptrdiff_t{0}, last));
}

bool LessonPlay::can_start(const LessonRun& run) const {
  return run.kind == LessonRun::Kind::run && run.stage == stage_.name;
}

LessonPlay::Progress LessonPlay::progress(std::size_t run) const { return pages_[place_].progress[run]; }

void LessonPlay::start(std::size_t run, Session& session) {
  const auto& words = exercise().runs[run].words;
  std::vector<const char*> argv{stage_.name.c_str()};
  for (const auto& word : words) argv.push_back(word.c_str());
  auto options = read_command_line(stage_, static_cast<int>(argv.size()), argv.data()).options;
  options.threads.value = session.simulation().threads();
  session.begin(options);
  if (current_) finish(Progress::changed);
  auto& page = pages_[place_];
  page.findings.begin(run);
  page.progress[run] = Progress::running;
  const auto& simulation = session.simulation();
  current_ = {.page = place_,
              .run = run,
              .start = session.starts(),
              .integrator = simulation.integrator(),
              .parameters = simulation.parameters().overrides()};
  const double until = options.until ? options.until->value : std::numeric_limits<double>::infinity();
  const long steps = options.steps ? options.steps->value : std::numeric_limits<long>::max();
  session.change_speed(
      octaves_to(std::min(until, static_cast<double>(steps) * simulation.dt()) / lasts, session));
  page.findings.look(run, session.simulation());
  session.watch([this, &session, run, until, steps, &findings = page.findings](Simulation& now) {
    if (!current_ || session.starts() != current_->start) return;
    findings.look(run, now);
    if (now.time() < until && now.steps() < steps) return;
    findings.end(run, now);
    finish(Progress::done);
  });
}

void LessonPlay::finish(Progress progress) {
  auto& page = pages_[current_->page];
  if (progress == Progress::changed) page.findings.begin(current_->run);
  page.progress[current_->run] = progress;
  current_.reset();
}

bool LessonPlay::is_unchanged(const Session& session) const {
  const auto& simulation = session.simulation();
  return session.starts() == current_->start && simulation.integrator() == current_->integrator &&
         same(simulation.parameters().overrides(), current_->parameters);
}

void LessonPlay::follow(Session& session) {
  if (!current_) return session.watch({});
  if (!is_unchanged(session)) return finish(Progress::changed);
  if (!session.diverged()) return;
  pages_[current_->page].findings.diverge(current_->run, session.diverged()->step);
  finish(Progress::done);
}

}  // namespace clapotis
