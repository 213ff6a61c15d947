#include "common/lesson/findings.hpp"

#include <algorithm>

#include "common/lesson/measure.hpp"

namespace clapotis {
namespace {

/// A state stands at a time when it is there to rounding.
bool has_reached(const Simulation& simulation, double time) {
  return simulation.time() >= time - 1e-9 * simulation.dt();
}

}  // namespace

void Findings::begin(std::size_t run) {
  for (std::size_t k = 0; k < found_.size(); ++k)
    if (exercise_->checks[k].run == run) found_[k].reset();
}

/// The checks of that side of that run that have found nothing yet, and for which `act` is called.
template <class Act>
void Findings::each_open(std::size_t run, std::string_view side, const Act& act) {
  for (std::size_t k = 0; k < found_.size(); ++k) {
    const auto& check = exercise_->checks[k];
    if (check.run == run && check.side == side && !found_[k]) act(check, found_[k]);
  }
}

void Findings::look(std::size_t run, Simulation& simulation, std::string_view side) {
  each_open(run, side, [&](const Check& check, std::optional<double>& found) {
    if (!check.time || !has_reached(simulation, *check.time)) return;
    if (const auto measured = measure(check.quantity, simulation)) found = measured->value;
  });
}

void Findings::end(std::size_t run, Simulation& simulation, std::string_view side) {
  each_open(run, side, [&](const Check& check, std::optional<double>& found) {
    if (check.time) return;
    if (const auto measured = measure(check.quantity, simulation)) found = measured->value;
  });
}

void Findings::diverge(std::size_t run, long step, std::string_view side) {
  each_open(run, side, [&](const Check& check, std::optional<double>& found) {
    if (check.quantity == diverged_step) found = static_cast<double>(step);
  });
}

void Findings::note(std::size_t run, std::string_view quantity, double value) {
  each_open(run, {}, [&](const Check& check, std::optional<double>& found) {
    if (check.quantity == quantity) found = value;
  });
}

bool Findings::complete(std::size_t run) const {
  for (std::size_t k = 0; k < found_.size(); ++k)
    if (exercise_->checks[k].run == run && !found_[k]) return false;
  return true;
}

}  // namespace clapotis
