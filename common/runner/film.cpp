#include "common/runner/film.hpp"

#include <algorithm>
#include <tuple>

#include "common/runner/sheet.hpp"
#include "common/simulation/errors.hpp"

namespace clapotis {
namespace {

constexpr int width = 1280, height = 720;
constexpr double share_of_frames = 0.95;  // an impact in a few frames must not darken all the others
constexpr std::size_t most_bytes_waiting = std::size_t{256} << 20;

std::size_t bytes(const Picture& picture) {
  return static_cast<std::size_t>(picture.x.size() + picture.y.size() + picture.value.size() +
                                  (picture.ghosts ? 2 * picture.ghosts->x.size() : 0)) *
         sizeof(double);
}

std::size_t bytes(const std::vector<Plot>& plots) {
  std::size_t sum = 0;
  for (const auto& plot : plots)
    for (const auto& curve : plot.curves) sum += (curve.xs.size() + curve.ys.size()) * sizeof(double);
  return sum;
}

double quantile(std::vector<double> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

Film::Film(std::filesystem::path file, double start, double interval, Colours colours)
    : video_(std::move(file), width, height),
      next_(start),
      interval_(interval),
      waits_(colours == Colours::one_for_all) {}

void Film::add(Picture picture, std::vector<Plot> plots, double time, double dt,
               std::optional<Beside> beside) {
  const double late = std::max(0.0, (time + rounding * dt - next_) / interval_);
  const long frames = 1 + static_cast<long>(late);
  next_ += static_cast<double>(frames) * interval_;
  frames_ += frames;
  waiting_bytes_ += bytes(picture) + bytes(plots) + (beside ? bytes(beside->right) : 0);
  waiting_.push_back({std::move(picture), std::move(plots), frames, std::move(beside)});
  if (!waits_ || waiting_bytes_ > most_bytes_waiting) paint_waiting([](double) {});
}

void Film::paint_waiting(const Told& painted) {
  if (waits_ && !range_.locked && !waiting_.empty()) {
    std::vector<double> depths, heights;  // alike, so that ends that are opposite remain so
    for (const auto& shot : waiting_) {
      depths.push_back(-shot.picture.colours.lo);
      heights.push_back(shot.picture.colours.hi);
    }
    range_.follow(-quantile(depths, share_of_frames), quantile(heights, share_of_frames));
  }
  range_.locked = true;  // what comes after the many that waited has their colours
  for (auto& shot : waiting_) {
    auto& [label, unit, lo, hi, map] = shot.picture.colours;
    if (waits_) std::tie(lo, hi) = range_.follow(lo, hi);
    if (shot.beside) shot.beside->right.colours = shot.picture.colours;
    paint(shot);
    painted(static_cast<double>(&shot - waiting_.data() + 1) / static_cast<double>(waiting_.size()));
  }
  waiting_.clear();
  waiting_bytes_ = 0;
}

void Film::paint(const Shot& shot) {
  CairoCanvas canvas({width, height});
  if (shot.beside) {
    paint_sheet(canvas, shot.picture, *shot.beside, shot.plots);
  } else {
    paint_sheet(canvas, shot.picture, shot.plots);
  }
  const auto pixels = canvas.pixels();
  for (long k = 0; k < shot.frames; ++k) video_.add(pixels);
}

void Film::finish(const Told& painted) {
  paint_waiting(painted);
  video_.finish();
}

double Film::seconds() const {
  return static_cast<double>(frames_) / static_cast<double>(VideoFile::frames_per_second);
}

void WantedFilm::attempt(const std::function<void(Film&)>& act) {
  if (!film_) return;
  try {
    act(*film_);
  } catch (const FileError& error) {
    failure_ = error.what();
    film_.reset();
  }
}

void WantedFilm::add(Picture picture, std::vector<Plot> plots, double time, double dt,
                     std::optional<Beside> beside) {
  attempt([&](Film& film) { film.add(std::move(picture), std::move(plots), time, dt, std::move(beside)); });
}

void WantedFilm::finish(const Film::Told& painted) {
  attempt([&](Film& film) { film.finish(painted); });
  film_.reset();
}

}  // namespace clapotis
