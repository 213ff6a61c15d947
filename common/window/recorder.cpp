#include "common/window/recorder.hpp"

#include "common/runner/saved_state.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

double film_interval(const Session& session) { return session.speed() / VideoFile::frames_per_second; }

}  // namespace

std::filesystem::path free_name(const Session& session, std::string_view extension) {
  const auto stem = fmt::format("{}-{}-t{:.3f}s", session.stage().name, session.simulation().scene().name,
                                session.simulation().time());
  std::filesystem::path file = fmt::format("{}{}", stem, extension);
  for (int k = 2; std::filesystem::exists(file); ++k) file = fmt::format("{}-{}{}", stem, k, extension);
  return file;
}

std::string Recorder::save(Session& session) {
  const auto file = free_name(session, ".state");
  write_state(file, copy_state(session.stage(), session.simulation()));
  saved_ = std::filesystem::absolute(file);
  return file.string();
}

void Recorder::restore(Session& session) const {
  if (saved_.empty()) throw BadInput(std::string(words().window.nothing_saved));
  session.restore(read_state(saved_, session.stage()));
}

void Recorder::begin(const Session& session) {
  film_.emplace(free_name(session, ".mp4"), session.simulation().time(), film_interval(session),
                Film::Colours::as_given);
  leaps_ = session.leaps();
}

void Recorder::shoot(const Session& session, const Picture& picture, const std::optional<Beside>& beside,
                     const std::vector<Plot>& plots) {
  if (!film_) return;
  const auto& simulation = session.simulation();
  if (leaps_ != session.leaps()) film_->go_on_from(session.time());
  leaps_ = session.leaps();
  film_->pace(film_interval(session));
  if (!film_->due(session.time(), simulation.dt())) return;
  try {
    film_->add(picture, plots, session.time(), simulation.dt(), beside);
  } catch (const FileError&) {
    film_.reset();
    throw;
  }
}

std::string Recorder::end() {
  if (!film_) return {};
  const auto file = film_->file().string();
  try {
    film_->finish();
  } catch (const FileError&) {
    film_.reset();
    throw;
  }
  film_.reset();
  return file;
}

}  // namespace clapotis
