#include "report/studies/measured.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/runner/compare_options.hpp"
#include "common/runner/interrupt.hpp"
#include "common/runner/stopwatch.hpp"
#include "report/in_turns.hpp"
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
  const auto [least, most] = std::minmax_element(seconds.begin(), seconds.end());
  const double middle = median(seconds);
  return {middle, (*most - *least) / middle};
}

Cost cost_until(const std::string& text, double until, int times,
                const std::function<void(Simulation&)>& watch) {
  Cost cost;
  bool watched = !watch;
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

Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  if (n < 2) return {};
  const double mean_x = std::reduce(x.begin(), x.end()) / n, mean_y = std::reduce(y.begin(), y.end()) / n;
  double xx = 0, xy = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    xx += (x[k] - mean_x) * (x[k] - mean_x), xy += (x[k] - mean_x) * (y[k] - mean_y);
  return {xy / xx, mean_y - xy / xx * mean_x};
}

PowerLaw power_law(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> log_x, log_y;
  for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k) {
    if (!(x[k] > 0 && y[k] > 0 && std::isfinite(x[k]) && std::isfinite(y[k]))) continue;
    log_x.push_back(std::log(x[k]));
    log_y.push_back(std::log(y[k]));
  }
  const auto line = line_through(log_x, log_y);
  return {line.slope, std::exp(line.at_zero)};
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

}  // namespace clapotis::studies
