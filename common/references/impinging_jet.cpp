#include "common/references/impinging_jet.hpp"

#include <cmath>
#include <numbers>

#include "common/references/require.hpp"

namespace clapotis {

double ImpingingJet::pressure(double x) const {
  const Demand demand{"ImpingingJet"};
  demand.positive(width, "width [m]");
  demand.positive(speed, "speed [m/s]");
  demand.positive(density, "density [kg/m^3]");
  const double wanted = std::abs(x) / width * std::numbers::pi / 2;
  double slow = 0, fast = 1;  // what is sought grows with s
  for (int halvings = 0; halvings < 60; ++halvings) {
    const double s = (slow + fast) / 2;
    (std::atan(s) + std::atanh(s) < wanted ? slow : fast) = s;
  }
  return density * speed * speed / 2 * (1 - slow * slow);
}

double ImpingingJet::surface(double x) const {
  const double pi = std::numbers::pi;
  return width * (0.5 + std::asinh(1 / std::sinh(pi * (x / width - 0.5))) / pi);
}

}  // namespace clapotis
