#include "stage4_sph/liquid.hpp"

#include <cmath>
#include <random>

#include "common/kernels/cubic_spline.hpp"
#include "common/kernels/lattice.hpp"
#include "common/kernels/wendland_c2.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"
#include "stage4_sph/parameters.hpp"

namespace clapotis::stage4 {
namespace {

/// dx^2 sum W on the lattice.
double lattice_sum(const Parameters& p, double h, double spacing) {
  return p.find("kernel")->text() == CubicSpline::name ? lattice_sums(CubicSpline(h), spacing).value
                                                       : lattice_sums(WendlandC2(h), spacing).value;
}

/// So many particles fit in no memory, and would be long in the making.
void require_room(double spacing, double across, double up) {
  constexpr double most = 1e8;
  if (across > 0 && up > 0 && across * up > most)
    throw BadInput(
        say(words().spacing_too_small, fmt::arg("value", to_text(spacing)), fmt::arg("most", to_text(most))));
}

}  // namespace

Fluid liquid(Parameters& p, double fastest, const Choices& choices) {
  p.choice(formulation);
  const double spacing = p.number(particle_spacing), h = spacing * p.number(h_over_dx);
  p.choice(choices.kernel);
  const bool sums = p.choice(choices.density) == "summation";
  const double reference = p.number(reference_density);
  auto c = sound_speed;
  c.value = 10 * fastest;
  if (!(p.number(c) > 0)) throw BadInput(say(words().no_sound_speed, fmt::arg("unit", p.length_unit())));
  p.number(polytropic_exponent);
  p.choice(bears_tension);
  p.derive(smoothing_length, h);
  const double mass = reference * spacing * spacing;
  p.derive(particle_mass, sums ? mass / lattice_sum(p, h, spacing) : mass);
  return Fluid::from(p);
}

Tank tank(Parameters& p, const Fluid& fluid) {
  const double width = p.number(tank_width), height = p.number(tank_height);
  const double support = 2 * fluid.h;
  require_room(fluid.spacing, width / fluid.spacing, height / fluid.spacing);
  if (p.choice(wall_form) == "reflect") return {width, height, {}};
  return {width, height, DummyWalls(tank_walls(0, width, 0, height, fluid.spacing, support), fluid, support)};
}

Particles particles_at(const Vectors& places, const Parameters& p) {
  Particles particles(places.rows(), p.value("particle_mass"));
  particles.kind = "fluid";
  particles.position = places;
  particles.density = Column::Constant(places.rows(), p.value("reference_density"));
  particles.pressure = Column::Zero(places.rows());
  if (p.find("density")->text() == "continuity") particles.density_rate = Column::Zero(places.rows());
  return particles;
}

Vectors lattice(double spacing, const Vector& origin, const Vector& low, const Vector& high,
                const std::function<bool(Vector)>& inside) {
  const auto first = [&](double from, double at) { return std::ceil((from - at) / spacing - 1e-9); };
  const auto last = [&](double to, double at) { return std::floor((to - at) / spacing + 1e-9); };
  require_room(spacing, last(high.x, origin.x) - first(low.x, origin.x) + 1,
               last(high.y, origin.y) - first(low.y, origin.y) + 1);
  std::vector<Vector> all;
  for (double b = first(low.y, origin.y); b <= last(high.y, origin.y); ++b)
    for (double a = first(low.x, origin.x); a <= last(high.x, origin.x); ++a) {
      const Vector r{origin.x + a * spacing, origin.y + b * spacing};
      if (inside(r)) all.push_back(r);
    }
  if (all.empty()) throw BadInput(say(words().spacing_too_large, fmt::arg("value", to_text(spacing))));
  Vectors places(static_cast<Index>(all.size()), 2);
  for (Index i = 0; i < places.rows(); ++i) {
    const auto& r = all[static_cast<std::size_t>(i)];
    places.row(i) << r.x, r.y;
  }
  return places;
}

Vectors disc(double spacing, const Vector& centre, double radius) {
  const Vector reach{radius, radius};
  return lattice(spacing, centre + Vector{spacing / 2, spacing / 2}, centre - reach, centre + reach,
                 [&](Vector r) { return norm(r - centre) <= radius * (1 + 1e-9); });
}

Vectors block(double spacing, double left, double right, double bottom, double top) {
  const double half = spacing / 2;
  return lattice(spacing, {left + half, bottom + half}, {left + half, bottom + half},
                 {right - half, top - half}, [](Vector) { return true; });
}

void disturb(Vectors& places, Parameters& p, double spacing) {
  std::mt19937_64 bits(static_cast<std::uint64_t>(p.integer(disturbance_seed)));
  const double most = p.number(disturbance) * spacing;
  for (const Index axis : {0, 1})
    for (Index i = 0; i < places.rows(); ++i)
      places(i, axis) += most * (2 * static_cast<double>(bits() >> 11) * 0x1p-53 - 1);
}

HydrostaticColumn at_rest(const Parameters& p) {
  return {.surface_density = p.value("reference_density"),
          .sound_speed = p.value("sound_speed"),
          .gamma = p.value("gamma"),
          .gravity = p.value("gravity")};
}

void rest_under_weight(Particles& particles, const Parameters& p, double height) {
  const auto column = at_rest(p);
  const double surface = column.compressed(height);
  for (Index i = 0; i < particles.size(); ++i) {
    const double below = column.compressed(height - particles.position(i, 1));
    particles.position(i, 1) = surface - below;
    particles.density(i) = column.density(below);
  }
}

}  // namespace clapotis::stage4
