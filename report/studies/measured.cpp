#include "report/studies/measured.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/runner/compare_options.hpp"
#include "common/runner/interrupt.hpp"
#include "common/runner/stopwatch.hpp"
#include "report/stages.hpp"

namespace clapotis::studies {

std::unique_ptr<Simulation> simulation(const std::string& text) {
  const auto side = read_side(all_stages(), text);
  return std::make_unique<Simulation>(*side.scene, side.parameters, side.integrator, side.threads);
}

std::string scene(const std::string& name, const std::vector<std::pair<std::string, std::string>>& values) {
  auto text = name;
  for (const auto& [parameter, value] : values)
    text += (text.size() == name.size() ? ":" : ",") + parameter + '=' + value;
  return text;
}

void heed_interrupt() {
  if (Interrupt::asked()) throw Interrupted{};
}

void advance(Simulation& simulation, double until, const std::function<void(Simulation&)>& after) {
  while (simulation.time() < until) {
    simulation.step(until);
    after(simulation);
    heed_interrupt();
  }
}

void advance_steps(Simulation& simulation, long steps, const std::function<void(Simulation&)>& after) {
  for (long step = 0; step < steps; ++step) {
    simulation.step();
    after(simulation);
    heed_interrupt();
  }
}

Timed timed(int times, const std::function<double()>& seconds_of_one) {
  std::vector<double> seconds;
  for (int k = 0; k < times; ++k) seconds.push_back(seconds_of_one());
  std::sort(seconds.begin(), seconds.end());
  const double median = (seconds[(seconds.size() - 1) / 2] + seconds[seconds.size() / 2]) / 2;
  return {median, (seconds.back() - seconds.front()) / median};
}

Cost cost_until(const std::string& text, double until, int times) {
  Cost cost;
  cost.seconds = timed(times, [&] {
    const auto run = simulation(text);
    const double start = processor_seconds();
    advance(*run, until);
    cost.steps = run->steps();
    cost.evaluations = run->system().force_evaluations;
    return processor_seconds() - start;
  });
  return cost;
}

Timed step_cost(Simulation& simulation, int times, double least) {
  return timed(times, [&] {
    const double start = processor_seconds();
    double taken = 0;
    long steps = 0;
    while (taken < least) {
      advance_steps(simulation, std::max(steps, 1L));  // twice as many as so far: the clock is read rarely
      steps += std::max(steps, 1L);
      taken = processor_seconds() - start;
    }
    return taken / static_cast<double>(steps);
  });
}

double PowerLaw::at(double x) const { return factor * std::pow(x, exponent); }

PowerLaw power_law(const std::vector<double>& x, const std::vector<double>& y) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k) {
    if (!(x[k] > 0 && y[k] > 0 && std::isfinite(x[k]) && std::isfinite(y[k]))) continue;
    const double a = std::log(x[k]), b = std::log(y[k]);
    n += 1, sx += a, sy += b, sxx += a * a, sxy += a * b;
  }
  if (n < 2) return {};
  const double exponent = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  return {exponent, std::exp((sy - exponent * sx) / n)};
}

double greater(double a, double b) { return std::isnan(a) || std::isnan(b) ? a + b : std::max(a, b); }

std::vector<std::size_t> pareto_front(const std::vector<double>& costs, const std::vector<double>& errors) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < costs.size(); ++k)
    if (std::isfinite(costs[k]) && std::isfinite(errors[k])) order.push_back(k);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return std::pair(costs[a], errors[a]) < std::pair(costs[b], errors[b]); });
  std::vector<std::size_t> front;
  for (const auto k : order)
    if (front.empty() || errors[k] < errors[front.back()]) front.push_back(k);
  return front;
}

Cost watched_cost(const std::string& text, double until, int times,
                  const std::function<void(Simulation&)>& watch) {
  Cost cost;
  bool watched = false;
  cost.seconds = timed(times, [&] {
    const auto run = simulation(text);
    const double start = processor_seconds();
    double looked = 0;
    advance(*run, until, [&](Simulation& s) {
      if (watched) return;
      const double before = processor_seconds();
      watch(s);
      looked += processor_seconds() - before;
    });
    watched = true;
    cost.steps = run->steps();
    cost.evaluations = run->system().force_evaluations;
    return processor_seconds() - start - looked;
  });
  return cost;
}

}  // namespace clapotis::studies
