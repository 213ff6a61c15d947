#include "common/window/scene_view.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "common/runner/ink.hpp"
#include "common/runner/save_sheet.hpp"
#include "common/runner/units.hpp"
#include "common/window/theme.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr double picture_scale = 0.85;  // titles leave room for the scene; the smallest letters are 15 pixels
constexpr double longest_arrow = 36;    // [pixel], for the velocity at the end of the range
constexpr Index arrow_heads = 2000;     // with more particles a head is a blot

std::string number(double value) { return fmt::format("{:.4g}", value == 0 ? 0.0 : value); }

void paint_box(Canvas& canvas, const Box& box) {
  canvas.rectangle({{box.corner.x - 1, box.corner.y - 1}, {box.extent.x + 2, box.extent.y + 2}}, ink::grid);
  canvas.rectangle(box, ink::paper);
}

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

}  // namespace

void SceneView::paint(Canvas& canvas, WindowState& state, const Box& area) {
  auto& session = state.session;
  auto& simulation = session.simulation();
  auto& sight = state.sight;
  keep_chosen(sight, simulation);
  picture_ = describe(session.stage().title, simulation, sight.viewpoint);
  picture_.subtitle = fmt::format("t = {:.3f} s   dt = {} s   N = {}", simulation.time(),
                                  step_text(simulation), simulation.particles().size());
  if (picture_.chosen)
    picture_.chosen->full_force = sight.force_range.follow(0, picture_.chosen->full_force).second;
  if (picture_.value.size() > 0) {
    auto& [label, unit, lo, hi, map] = picture_.colours;
    std::tie(lo, hi) = sight.colour_range.follow(lo, hi);
  }
  const double scale = state.scale;
  const double plots_height =
      sight.plots || sight.viewpoint.kernel ? std::clamp(0.30 * area.extent.y, 0.0, 300 * scale) : 0;
  const Box above{area.corner, {area.extent.x, area.extent.y - plots_height}};
  view_ = sight.view(picture_, above, picture_scale * scale);
  painter_.paint(canvas, picture_, view_);
  canvas.clip(view_.scene);
  if (sight.vectors) paint_velocities(canvas, state);
  paint_brush(canvas, state);
  canvas.unclip();
  plots_ = picture_.chosen && sight.viewpoint.kernel ? picture_.chosen->kernel
                                                     : plots(session.history(), simulation);
  if (plots_height < 60 * scale) return;
  const double width = area.extent.x / static_cast<double>(plots_.size());
  for (std::size_t k = 0; k < plots_.size(); ++k) {
    const Box box{{area.corner.x + static_cast<double>(k) * width, area.corner.y + above.extent.y},
                  {width, plots_height}};
    clapotis::paint(canvas, plots_[k], box, picture_scale * scale);
  }
}

void SceneView::paint_velocities(Canvas& canvas, WindowState& state) {
  const auto& particles = state.session.simulation().particles();
  const double typical = std::sqrt(particles.velocity.square().rowwise().sum().mean());
  const double range = state.sight.arrow_range.follow(0, std::min(2 * typical, max_speed(particles))).second;
  const double high = range > 0 ? range : 1;
  const double length = longest_arrow * state.scale / high;
  ends_.clear();
  for (Index i = 0; i < particles.size(); ++i) {
    const Vector v = row(particles.velocity, i);
    const Point from = view_.to_pixel(particles.position(i, 0), particles.position(i, 1));
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
  paint_arrow_key(canvas, state, high);
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
  paint_box(canvas, {corner, extent});
  const Point left{corner.x + margin, corner.y + extent.y / 2}, right{left.x + length, left.y};
  const double head = 6 * scale;
  canvas.segments(std::array{left, right, right, Point{right.x - head, right.y - head / 2}, right,
                             Point{right.x - head, right.y + head / 2}},
                  ink::text, 2 * scale);
  canvas.text({right.x + margin, right.y + 0.36 * height}, label, height, ink::text);
}

Box SceneView::domain() const {
  const Point corner = view_.to_pixel(picture_.lower.x(), picture_.upper.y());
  const Eigen::Array2d extent = (picture_.upper - picture_.lower) * view_.pixels_per_unit;
  return {corner, {extent.x(), extent.y()}};
}

std::string SceneView::save(const Session& session) const {
  const auto file = free_name(session, ".png");
  save_sheet(file, picture_, plots_);
  return file.string();
}

}  // namespace clapotis
