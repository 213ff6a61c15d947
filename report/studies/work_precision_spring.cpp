#include <cmath>

#include "common/simulation/parameters.hpp"
#include "report/studies/studies.hpp"
#include "report/studies/work_precision.hpp"

namespace clapotis::studies {
namespace {

/// Two discs meet in the middle of the box, some 10 ms after the start, each time at another moment of the
/// step: what one contact does hangs on that moment. Steps of the golden ratio spread the moments evenly over
/// steps of any length.
std::vector<Values> moments() {
  constexpr double middle = 400, radius = 10, gap = 4, longest_way = 1.5;  // [px], of scene pair
  std::vector<Values> starts;
  for (int phase = 0; phase < 32; ++phase) {
    const double share = std::fmod(phase * 0.6180339887498949, 1.0);
    starts.push_back({{"x0", to_text(middle - radius - (gap + longest_way * share) / 2)}});
  }
  return starts;
}

}  // namespace

/// Contact lasts 5.7 ms, until 20 ms at the latest; the discs are far from the walls at 30 ms.
Study work_precision_spring() {
  return work_precision(
      {.name = "work_precision_spring",
       .question = "Which integrator follows two discs through their contact at the least cost?",
       .unit = "px",
       .until = 0.03,
       .instants = 8,
       .lanes = {{.name = "head-on",
                  .scene = "stage2/pair",
                  .starts = moments(),
                  .schemes = {"explicit_euler", "symplectic_euler", "velocity_verlet", "rk2", "rk4",
                              "bogacki_shampine"}}}});
}

}  // namespace clapotis::studies
