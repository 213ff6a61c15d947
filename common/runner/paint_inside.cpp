#include "common/runner/paint_inside.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/runner/ink.hpp"
#include "common/runner/ticks.hpp"

namespace clapotis {
namespace {

constexpr double smallest_mark = 5;       ///< radius of the ring around a marked particle [pixel]
constexpr double longest_arrow = 120;     ///< of the force at the end of the range [pixel]
constexpr double thin = 4.5, thick = 11;  ///< arrows of one law, and of their sum below them [pixel]

Point place_of(const Picture& picture, const PictureView& view) {
  const auto i = picture.chosen->particle;
  return view.to_pixel(picture.x[i], picture.y[i]);
}

bool is_place(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// From `from` by `along`, with a head; a short one is thinner.
void paint_arrow(Canvas& canvas, Point from, Point along, Colour colour, double width, double rim = 0) {
  const double length = std::hypot(along.x, along.y);
  if (!(length > 1.5)) return;  // false for NaN, too
  const Point tip{from.x + along.x, from.y + along.y};
  const double line = std::min(width, 0.3 * length), head = std::min(3 * width, 0.6 * length) / length;
  const double spread = 0.55 * head;
  const Point left{tip.x - head * along.x - spread * along.y, tip.y - head * along.y + spread * along.x};
  const Point right{tip.x - head * along.x + spread * along.y, tip.y - head * along.y - spread * along.x};
  canvas.line(std::array{from, tip}, colour, line + rim);
  canvas.line(std::array{left, tip, right}, colour, line + rim);
}

double length_per_force(const Chosen& chosen, const PictureView& view) {
  return chosen.full_force > 0 ? longest_arrow * view.scale / chosen.full_force : 0;
}

/// Title and values, then how long is how much, and the magnitudes of the forces at the right end.
class FactsTable {
 public:
  FactsTable(Canvas& canvas, const Chosen& chosen, const PictureView& view)
      : canvas_(canvas), chosen_(chosen), view_(view), scale_(view.scale) {
    first_force_ = chosen.facts.size() - chosen.forces.size();
    rows_ = static_cast<double>(1 + chosen.facts.size() + (chosen.forces.empty() ? 0 : 1));
    height_ = std::min(ink::numbers * scale_, (view.scene.extent.y - 3 * margin()) / (leading * rows_));
    full_force_ = tick_label(chosen.full_force, chosen.full_force) + " " + chosen.force_unit;
    double widest = chosen.forces.empty() ? 0 : longest_arrow * scale_ + margin() + text_width(full_force_);
    for (std::size_t k = 0; k < first_force_; ++k)
      names_ = std::max(names_, text_width(chosen.facts[k].name));
    for (const auto& fact : chosen.facts) {
      const double name = fact.colour ? indent() + text_width(fact.name) : names_;
      widest = std::max(widest, name + margin() + text_width(fact.value));
    }
    widest = std::max(widest, text_width(chosen.title));
    const double step = 2 * height_;  // a box that breathes with every digit is not calm
    width_ = bar() + 2 * margin() + step * std::ceil(widest / step);
  }

  void paint(Point particle) {
    const Box& scene = view_.scene;
    const bool on_the_left = particle.x < scene.corner.x + scene.extent.x / 2;
    const double from_left = on_the_left ? scene.extent.x - width_ - margin() : margin();
    const Point corner{scene.corner.x + from_left, scene.corner.y + margin()};
    const Box box{corner, {width_, rows_ * leading * height_ + margin()}};
    ink::paper_box(canvas_, box);
    canvas_.rectangle({corner, {bar(), box.extent.y}}, ink::chosen);
    at_ = {corner.x + bar() + margin(), corner.y};
    next_row();
    canvas_.text(at_, chosen_.title, height_, ink::faint_text);
    for (std::size_t k = 0; k < chosen_.facts.size(); ++k) {
      if (k == first_force_) paint_key();
      paint_fact(chosen_.facts[k], k + 1 == chosen_.facts.size());
    }
  }

 private:
  void next_row() { at_.y += leading * height_; }

  /// How long is how much.
  void paint_key() {
    next_row();
    if (!(chosen_.full_force > 0)) return;  // the row stays: the table stands still
    const Point from{at_.x, at_.y - 0.32 * height_};
    paint_arrow(canvas_, from, {longest_arrow * scale_, 0}, ink::faint_text, thin * scale_);
    canvas_.text({value_end(), at_.y}, full_force_, height_, ink::faint_text, Align::right);
  }

  void paint_fact(const ParticleFact& fact, bool is_sum) {
    next_row();
    if (!fact.colour) {
      canvas_.text(at_, fact.name, height_, ink::text);
      canvas_.text({at_.x + names_ + margin(), at_.y}, fact.value, height_, ink::text);
      return;
    }
    const double middle = at_.y - 0.32 * height_, end = at_.x + indent() - 0.7 * height_;
    canvas_.segments(std::array{Point{at_.x, middle}, Point{end, middle}}, *fact.colour,
                     (is_sum ? thick : thin + 2) * scale_);
    canvas_.text({at_.x + indent(), at_.y}, fact.name, height_, ink::text);
    canvas_.text({value_end(), at_.y}, fact.value, height_, ink::text, Align::right);
  }

  [[nodiscard]] double text_width(const std::string& text) const { return canvas_.text_width(text, height_); }
  [[nodiscard]] double margin() const { return 10 * scale_; }
  [[nodiscard]] double bar() const { return 5 * scale_; }
  [[nodiscard]] double value_end() const { return at_.x + width_ - bar() - 2 * margin(); }
  /// Before the name of a force stands a piece of its arrow.
  [[nodiscard]] double indent() const { return 2 * height_; }

  static constexpr double leading = 1.35;
  Canvas& canvas_;
  const Chosen& chosen_;
  const PictureView& view_;
  double scale_, rows_ = 0, height_ = 0, names_ = 0, width_ = 0;
  std::size_t first_force_ = 0;
  std::string full_force_;
  Point at_;
};

}  // namespace

void paint_visited_cells(Canvas& canvas, const Picture& picture, const PictureView& view) {
  if (!picture.chosen) return;
  const auto& [low, high] = picture.chosen->visited;
  const Point corner = view.to_pixel(low.x, high.y), opposite = view.to_pixel(high.x, low.y);
  if (!(opposite.x > corner.x && opposite.y > corner.y)) return;
  canvas.rectangle({corner, {opposite.x - corner.x, opposite.y - corner.y}}, ink::visited);
  canvas.line(std::array{corner, Point{opposite.x, corner.y}, opposite, Point{corner.x, opposite.y}, corner},
              ink::in_vain, 3 * view.scale);
}

void add_chosen_rings(const Picture& picture, const PictureView& view, std::vector<Disc>& rings) {
  if (!picture.chosen) return;
  const auto& chosen = *picture.chosen;
  const double scale = view.scale;
  const double radius = std::max(picture.radius * view.pixels_per_unit, smallest_mark * scale);
  const auto ring = [&](Point centre, double outer, double width, Colour colour) {
    if (is_place(centre)) rings.push_back({centre, outer, colour, std::max(0.0, outer - width)});
  };
  const auto where = [&](Eigen::Index i) { return view.to_pixel(picture.x[i], picture.y[i]); };
  for (const auto i : chosen.in_vain)
    ring(where(i), radius + scale, std::max(2 * scale, 0.2 * radius), ink::in_vain);
  for (const auto& r : chosen.walls) {
    const Point centre = view.to_pixel(r.x, r.y);
    ring(centre, radius, radius, ink::wall);
    ring(centre, radius, std::max(2 * scale, 0.25 * radius), ink::chosen);
  }
  for (const auto i : chosen.neighbours)
    ring(where(i), radius + scale, std::max(2.5 * scale, 0.3 * radius), ink::chosen);
  const auto self = where(chosen.particle);
  ring(self, radius + 3 * scale, 4 * scale, ink::paper);
  ring(self, radius + 3 * scale + 2, std::max(3 * scale, 0.3 * radius), ink::text);
}

void paint_support(Canvas& canvas, const Picture& picture, const PictureView& view) {
  if (!picture.chosen || picture.chosen->support <= 0) return;
  constexpr int sides = 128;
  const Point centre = place_of(picture, view);
  const double reach = picture.chosen->support * view.pixels_per_unit;
  std::array<Point, sides + 1> rim;
  for (int k = 0; k <= sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    rim[static_cast<std::size_t>(k)] = {centre.x + reach * std::cos(angle),
                                        centre.y + reach * std::sin(angle)};
  }
  if (is_place(rim.front())) canvas.line(rim, ink::chosen, 3 * view.scale);
}

/// The sum lies below, wide: a law that makes all of it lies inside. Of laws that pull the same way the
/// longer one lies below. A pale rim tells all of them from the particles.
void paint_forces(Canvas& canvas, const Picture& picture, const PictureView& view) {
  if (!picture.chosen || picture.chosen->forces.empty()) return;
  const Point centre = place_of(picture, view);
  if (!is_place(centre)) return;
  const auto& forces = picture.chosen->forces;
  const double pixels = length_per_force(*picture.chosen, view);
  std::vector<const ForceArrow*> laws;
  for (std::size_t k = 0; k + 1 < forces.size(); ++k) laws.push_back(&forces[k]);
  std::ranges::stable_sort(laws, std::ranges::greater{}, [](const auto* f) { return norm(f->force); });
  const auto arrow = [&](const ForceArrow& f, double width, Colour colour, double rim) {
    const Point along{f.force.x * pixels, -f.force.y * pixels};
    paint_arrow(canvas, centre, along, colour, width * view.scale, rim * view.scale);
  };
  arrow(forces.back(), thick, ink::paper, 3);
  for (const auto* f : laws) arrow(*f, thin, ink::paper, 3);
  arrow(forces.back(), thick, forces.back().colour, 0);
  for (const auto* f : laws) arrow(*f, thin, f->colour, 0);
}

void paint_facts(Canvas& canvas, const Picture& picture, const PictureView& view) {
  if (!picture.chosen || picture.chosen->title.empty()) return;
  FactsTable(canvas, *picture.chosen, view).paint(place_of(picture, view));
}

}  // namespace clapotis
