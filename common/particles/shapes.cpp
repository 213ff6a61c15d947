#include "common/particles/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "common/simulation/errors.hpp"
#include "common/simulation/parameters.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

/// Hexagonal lattice of the given spacing, whose points may move by (spacing - 2h)/2 without leaving `room`.
class Lattice {
 public:
  Lattice(double spacing, double h, const Rectangle& room)
      : spacing_(spacing), play_(spacing / 2 - h), corner_{room.left + play_, room.bottom + play_} {
    const double width = room.right - room.left - 2 * play_, height = room.top - room.bottom - 2 * play_;
    if (width < 0 || height < 0) return;
    even_ = places(width);
    odd_ = width >= spacing / 2 ? places(width - spacing / 2) : 0;
    lines_ = std::floor(height / (spacing * std::sqrt(0.75)) + 1e-9) + 1;
  }
  [[nodiscard]] double count() const {
    return std::floor((lines_ + 1) / 2) * even_ + std::floor(lines_ / 2) * odd_;
  }
  [[nodiscard]] double play() const { return play_; }

  [[nodiscard]] Vector point(Index k) const {
    const double two_lines = even_ + odd_, pair = std::floor(static_cast<double>(k) / two_lines);
    const double place = static_cast<double>(k) - pair * two_lines;
    const bool odd = place >= even_;
    return {corner_.x + spacing_ * (odd ? place - even_ + 0.5 : place),
            corner_.y + spacing_ * std::sqrt(0.75) * (2 * pair + (odd ? 1 : 0))};
  }

 private:
  [[nodiscard]] double places(double width) const { return std::floor(width / spacing_ + 1e-9) + 1; }

  double spacing_, play_;
  Vector corner_;
  double even_ = 0, odd_ = 0, lines_ = 0;  // whole numbers, beyond any integer type for the smallest discs
};

}  // namespace

Vectors scattered_discs(Index count, double h, const Rectangle& room, std::uint64_t seed,
                        std::string_view unit) {
  const Lattice closest(2 * h, h, room);
  if (closest.count() < static_cast<double>(count))
    throw BadInput(say(words().too_many_discs, fmt::arg("count", count), fmt::arg("radius", to_text(h)),
                       fmt::arg("unit", unit), fmt::arg("most", closest.count())));
  double fits = 2 * h, too_wide = 2 * h + std::max(room.right - room.left, room.top - room.bottom);
  for (int halvings = 0; halvings < 60; ++halvings) {
    const double spacing = (fits + too_wide) / 2;
    (Lattice(spacing, h, room).count() >= static_cast<double>(count) ? fits : too_wide) = spacing;
  }
  const Lattice lattice(fits, h, room);

  std::mt19937_64 bits(seed);
  const auto uniform = [&] {
    return static_cast<double>(bits() >> 11) * 0x1p-53;
  };  // the same on every machine
  Vectors places(count, 2);
  for (Index k = 0; k < count; ++k) {
    const double angle = 2 * M_PI * uniform(), reach = lattice.play() * std::sqrt(uniform());
    const Vector centre = lattice.point(k) + Vector{reach * std::cos(angle), reach * std::sin(angle)};
    places.row(k) << std::clamp(centre.x, room.left, room.right), std::clamp(centre.y, room.bottom, room.top);
  }
  return places;
}

}  // namespace clapotis
