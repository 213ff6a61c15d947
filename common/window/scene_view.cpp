#include "common/window/scene_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "common/runner/ink.hpp"
#include "common/runner/save_sheet.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr double picture_scale = 0.85;  // titles leave room for the scene; the smallest letters are 15 pixels
constexpr double longest_arrow = 36;    // [pixel], for the velocity at the end of the range
constexpr Index arrow_heads = 2000;     // with more particles a head is a blot

std::string number(double value) { return fmt::format("{:.4g}", value == 0 ? 0.0 : value); }

/// Who left is chosen no more; the kernel goes on with another one.
void keep_chosen(Sight& sight, const Simulation& simulation) {
  auto& id = sight.viewpoint.chosen;
  auto& kernel = sight.viewpoint.kernel;
  if (id && !simulation.particles().place_of(*id)) {
    id.reset();
    if (kernel) sight.select_middle(simulation);
  }
  if (!id) kernel = false;
}

/// That of the longest arrow.
double arrow_speed(const Particles& particles) {
  const double typical = std::sqrt(particles.velocity.square().rowwise().sum().mean());
  return std::min(2 * typical, max_speed(particles));
}

/// As many of them as have room; difference, which the errors tell, goes first.
std::vector<Plot> plots_of_sides(const SideBySide& sides, double width) {
  constexpr double narrowest = 280;  // [pixel]
  auto all = compare_plots(sides.distances(), sides.left(), sides.right());
  const auto most = static_cast<std::size_t>(std::max(2.0, width / narrowest));
  if (all.size() > most) all.resize(most);
  return all;
}

}  // namespace

void SceneView::paint(Canvas& canvas, WindowState& state, const Box& area) {
  auto& sight = state.sight;
  keep_chosen(sight, state.session.simulation());
  describe_all(state);
  share_ranges(sight);
  const double scale = state.scale;
  const double plots_height =
      sight.plots || sight.viewpoint.kernel ? std::clamp(0.30 * area.extent.y, 0.0, 300 * scale) : 0;
  const Box above{area.corner, {area.extent.x, area.extent.y - plots_height}};
  paint_scenes(canvas, state, above);
  describe_curves(state, area.extent.x / scale);
  if (plots_height < 60 * scale) return;
  const double width = area.extent.x / static_cast<double>(plots_.size());
  for (std::size_t k = 0; k < plots_.size(); ++k) {
    const Box box{{area.corner.x + static_cast<double>(k) * width, area.corner.y + above.extent.y},
                  {width, plots_height}};
    clapotis::paint(canvas, plots_[k], box, picture_scale * scale);
  }
}

void SceneView::describe_all(WindowState& state) {
  auto& session = state.session;
  beside_.reset();
  if (auto* sides = session.sides()) return describe_sides(state, *sides);
  auto& simulation = session.simulation();
  picture_ = describe(session.stage().title, simulation, state.sight.viewpoint);
  picture_.subtitle = fmt::format("t = {:.3f} s   dt = {} s   N = {}", simulation.time(),
                                  step_text(simulation), simulation.particles().size());
}

/// Forces and colours have one range each, on both sides.
void SceneView::share_ranges(Sight& sight) {
  if (picture_.chosen) {
    double& force = picture_.chosen->full_force;
    double* other = beside_ && beside_->right.chosen ? &beside_->right.chosen->full_force : nullptr;
    force = sight.force_range.follow(0, other != nullptr ? std::max(force, *other) : force).second;
    if (other != nullptr) *other = force;
  }
  if (picture_.value.size() == 0) return;
  auto& [label, unit, lo, hi, map] = picture_.colours;
  std::tie(lo, hi) = sight.colour_range.follow(lo, hi);
  if (beside_) beside_->right.colours = picture_.colours;
}

/// One, or two in halves, with what is painted over them.
void SceneView::paint_scenes(Canvas& canvas, WindowState& state, const Box& area) {
  auto& sight = state.sight;
  const auto& simulation = state.session.simulation();
  const auto halves = split(area, picture_, picture_scale * state.scale);
  view_ = sight.view(picture_, beside_ ? halves.left : area, picture_scale * state.scale);
  painter_.paint(canvas, picture_, view_);
  canvas.clip(view_.scene);
  if (sight.vectors) {
    const auto* sides = state.session.sides();
    const double right = sides != nullptr ? arrow_speed(sides->right().simulation->particles()) : 0;
    arrow_speed_ = sight.arrow_range.follow(0, std::max(arrow_speed(simulation.particles()), right)).second;
    paint_velocities(canvas, state, simulation, view_);
  }
  paint_brush(canvas, state);
  canvas.unclip();
  if (beside_) paint_right(canvas, state, halves);
}

/// What stands below the scene, `width` pixels wide at scale 1.
void SceneView::describe_curves(const WindowState& state, double width) {
  const auto& session = state.session;
  if (picture_.chosen && state.sight.viewpoint.kernel)
    plots_ = picture_.chosen->kernel;
  else if (session.sides() != nullptr)
    plots_ = plots_of_sides(*session.sides(), width);
  else
    plots_ = plots(session.history(), session.simulation());
}

/// Of the left side in one half, of the right side in the other.
void SceneView::describe_sides(WindowState& state, SideBySide& sides) {
  const auto& left = *sides.left().simulation;
  const auto what = sides.contrast();
  picture_ = describe_side(sides.left(), printed_contrast(left, {what.name, value_of(left, what.name)}),
                           left_colour(), state.sight.viewpoint);
  auto right =
      describe_side(sides.right(), printed_contrast(left, what), right_colour(), state.sight.viewpoint);
  share_colours(picture_, right, sides.left(), sides.right());
  beside_ = clapotis::beside(sides.left(), sides.right(), std::move(right), sides.time());
}

void SceneView::paint_right(Canvas& canvas, WindowState& state, const SplitArea& area) {
  const double scale = picture_scale * state.scale;
  right_view_ = state.sight.view(beside_->right, area.right, scale);
  painter_.paint(canvas, beside_->right, right_view_);
  canvas.clip(right_view_.scene);
  if (state.sight.vectors)
    paint_velocities(canvas, state, *state.session.sides()->right().simulation, right_view_);
  canvas.unclip();
  paint_frame(canvas, picture_, *beside_, area, scale);
}

void SceneView::paint_velocities(Canvas& canvas, WindowState& state, const Simulation& simulation,
                                 const PictureView& view) {
  const auto& particles = simulation.particles();
  const double high = arrow_speed_ > 0 ? arrow_speed_ : 1;
  const double length = longest_arrow * state.scale / high;
  ends_.clear();
  for (Index i = 0; i < particles.size(); ++i) {
    const Vector v = row(particles.velocity, i);
    const Point from = view.to_pixel(particles.position(i, 0), particles.position(i, 1));
    const Point arrow{v.x * length, -v.y * length};
    if (!(arrow.x * arrow.x + arrow.y * arrow.y > 4)) continue;  // false for NaN, too
    const Point tip{from.x + arrow.x, from.y + arrow.y};
    ends_.insert(ends_.end(), {from, tip});
    if (particles.size() > arrow_heads) continue;
    for (const double side : {-0.14, 0.14}) {
      ends_.push_back(tip);
      ends_.push_back({tip.x - 0.3 * arrow.x + side * arrow.y, tip.y - 0.3 * arrow.y - side * arrow.x});
    }
  }
  canvas.segments(ends_, ink::text, 1.5 * state.scale);
  if (&view == &view_) paint_arrow_key(canvas, state, high);
}

/// How far the tool reaches.
void SceneView::paint_brush(Canvas& canvas, const WindowState& state) {
  const double radius = brush_radius(state.session.simulation(), state.tool) * view_.pixels_per_unit;
  if (!state.mouse || radius == 0) return;
  const double rim = 2 * state.scale;
  canvas.discs(std::array{Disc{*state.mouse, radius, ink::chosen, radius - rim}});
}

/// In a corner of the scene: how long the arrow of a round speed is.
void SceneView::paint_arrow_key(Canvas& canvas, const WindowState& state, double speed) {
  const double scale = state.scale, margin = 10 * scale, height = 16 * scale, length = longest_arrow * scale;
  const auto label = say(words().window.velocity_scale, fmt::arg("speed", number(speed)),
                         fmt::arg("unit", state.session.simulation().scene().length_unit + "/s"));
  const Point extent{length + canvas.text_width(label, height) + 3 * margin, 2 * height};
  const Point corner{view_.scene.corner.x + margin,
                     view_.scene.corner.y + view_.scene.extent.y - margin - extent.y};
  ink::paper_box(canvas, {corner, extent});
  const Point left{corner.x + margin, corner.y + extent.y / 2}, right{left.x + length, left.y};
  const double head = 6 * scale;
  canvas.segments(std::array{left, right, right, Point{right.x - head, right.y - head / 2}, right,
                             Point{right.x - head, right.y + head / 2}},
                  ink::text, 2 * scale);
  canvas.text({right.x + margin, right.y + 0.36 * height}, label, height, ink::text);
}

std::string SceneView::save(const Session& session) const {
  const auto file = free_name(session, ".png");
  if (beside_) {
    save_sheet(file, picture_, *beside_, plots_);
  } else {
    save_sheet(file, picture_, plots_);
  }
  return file.string();
}

}  // namespace clapotis
