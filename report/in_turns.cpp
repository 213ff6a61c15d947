#include "report/in_turns.hpp"

#include <algorithm>

namespace clapotis {

std::vector<Turn> in_turns(Simulation& base, Simulation& other, int turns, int steps,
                           const std::function<double()>& clock) {
  const auto seconds = [&](Simulation& simulation) {
    const double start = clock();
    for (int step = 0; step < steps; ++step) simulation.step();
    return (clock() - start) / steps;
  };
  std::vector<Turn> all;
  for (int turn = 0; turn < turns; ++turn) {
    const double before = seconds(base);
    all.push_back({before, seconds(other)});
  }
  return all;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

double median_of(const std::vector<Turn>& turns, const std::function<double(const Turn&)>& number) {
  std::vector<double> values;
  for (const auto& turn : turns) values.push_back(number(turn));
  return median(std::move(values));
}

}  // namespace clapotis
