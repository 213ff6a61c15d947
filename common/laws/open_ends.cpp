#include "common/laws/open_ends.hpp"

#include <cmath>

namespace clapotis {

void OpenEnds::renew(System& s, double fastest, const std::function<double(Index)>& energy_of) const {
  if (outlet_) take_out(s, fastest, energy_of);
  for (const auto& inlet : inlets_) feed(s, inlet, energy_of);
}

void OpenEnds::take_out(System& s, double fastest, const std::function<double(Index)>& energy_of) const {
  std::vector<char> stays;
  for (Index i = 0; i < s.particles.size(); ++i) {
    const Vector r = row(s.position, i), v = row(s.velocity, i);
    if (outlet_->all.contains(r) || !(dot(v, v) <= fastest * fastest)) continue;
    stays.resize(static_cast<std::size_t>(s.particles.size()), 1);
    stays[static_cast<std::size_t>(i)] = 0;
    s.dissipated_energy += energy_of(i);
    ++s.left;
  }
  if (!stays.empty()) s.particles.keep(stays);
}

void OpenEnds::feed(System& s, const Inlet& inlet, const std::function<double(Index)>& energy_of) const {
  struct Last {
    Index particle = -1;
    double from_rear = 0;
  };
  std::vector<Last> last(static_cast<std::size_t>(std::lround(inlet.width / inlet.spacing)));
  for (Index i = 0; i < s.particles.size(); ++i) {
    const Vector r = row(s.position, i);
    if (!inlet.contains(r)) continue;
    const auto k = static_cast<std::size_t>(dot(r - inlet.rear, inlet.across) / inlet.spacing);
    const double from_rear = dot(r - inlet.rear, inlet.along);
    if (k < last.size() && (last[k].particle < 0 || from_rear < last[k].from_rear)) last[k] = {i, from_rear};
  }
  std::vector<Index> parents;
  for (const auto& [particle, from_rear] : last)
    if (particle >= 0 && from_rear >= inlet.spacing) parents.push_back(particle);
  if (parents.empty()) return;
  auto& p = s.particles;
  Index born = p.append(static_cast<Index>(parents.size()));
  for (const Index parent : parents) {
    const Vector r = row(p.position, parent) - inlet.spacing * inlet.along;
    p.position.row(born) << r.x, r.y;
    p.velocity.row(born) = p.velocity.row(parent);
    p.density(born) = p.density(parent);
    p.pressure(born) = p.pressure(parent);
    s.dissipated_energy -= energy_of(born);
    ++s.entered;
    ++born;
  }
}

}  // namespace clapotis
