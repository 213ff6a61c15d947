#include "report/studies/flows.hpp"

#include <Eigen/QR>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace clapotis::studies {

double measure(const Simulation& run, std::string_view name) {
  for (const auto& each : run.setup().measures)
    if (each.name == name) return each.value(run.system());
  throw std::logic_error("the scene does not measure " + std::string(name));
}

Timed cost_per_second(Simulation& run) {
  const double steps = static_cast<double>(run.steps()) / run.time();
  const auto step = step_cost(run, 5);
  return {step.median * steps, step.spread};
}

std::vector<Extreme> extremes(const Series& series) {
  const auto& [t, y] = series;
  std::vector<Extreme> all;
  for (std::size_t k = 2; k < t.size(); ++k) {
    const double before = (y[k - 1] - y[k - 2]) / (t[k - 1] - t[k - 2]),
                 after = (y[k] - y[k - 1]) / (t[k] - t[k - 1]);
    if (before * after >= 0) continue;
    const double top = (t[k - 2] + t[k - 1]) / 2 + before / (before - after) * (t[k] - t[k - 2]) / 2;
    const double from = top - t[k - 1];  // Newton's form of the parabola, about the middle instant
    all.push_back({top, y[k - 1] + from * (before + (from + t[k - 1] - t[k - 2]) * (after - before) /
                                                        (t[k] - t[k - 2]))});
  }
  return all;
}

std::vector<double> zeros(const Series& series) {
  const auto& [t, y] = series;
  std::vector<double> all;
  for (std::size_t k = 1; k < t.size(); ++k)
    if (y[k - 1] * y[k] < 0) all.push_back(t[k - 1] + (t[k] - t[k - 1]) * y[k - 1] / (y[k - 1] - y[k]));
  return all;
}

double free_frequency(const Series& series, double guess, double driven) {
  const auto count = static_cast<Eigen::Index>(series.t.size());
  const auto t = Eigen::Map<const Eigen::ArrayXd>(series.t.data(), count);
  const auto y = Eigen::Map<const Eigen::VectorXd>(series.y.data(), count);
  const auto distance = [&](double w) {
    Eigen::MatrixXd terms(count, 4);
    terms << Eigen::VectorXd::Ones(count), (w * t).cos().matrix(), (w * t).sin().matrix(),
        (driven * t).cos().matrix();
    return (terms * terms.colPivHouseholderQr().solve(y) - y).norm();
  };
  double low = 0.9 * guess, high = 1.1 * guess;  // golden section
  while (high - low > 1e-6 * guess) {
    const double part = (high - low) / std::numbers::phi;
    const double left = high - part, right = low + part;
    if (distance(left) < distance(right))
      high = right;
    else
      low = left;
  }
  return (low + high) / 2;
}

}  // namespace clapotis::studies
