#include "stage5_extensions/lines.hpp"

#include <cmath>
#include <limits>

namespace clapotis::stage5 {

Vectors upright(Vectors line) {
  line.col(0).swap(line.col(1));
  return line;
}

Vectors both(const Vectors& first, const Vectors& second) {
  Vectors lines(first.rows() + 1 + second.rows(), 2);
  lines.topRows(first.rows()) = first;
  lines.row(first.rows()) = std::numeric_limits<double>::quiet_NaN();
  lines.bottomRows(second.rows()) = second;
  return lines;
}

Vectors velocity_profile(const System& s, double x, double near, double scale) {
  Vectors points(s.particles.size(), 2);
  Index count = 0;
  for (Index i = 0; i < s.particles.size(); ++i)
    if (std::abs(s.position(i, 0) - x) <= near)
      points.row(count++) << x + scale * s.velocity(i, 0), s.position(i, 1);
  points.conservativeResize(count, 2);
  return points;
}

}  // namespace clapotis::stage5
