#include "common/window/past.hpp"

#include <algorithm>

namespace clapotis {
namespace {

long interventions(Past::Simulations simulations) {
  long sum = 0;
  for (const auto* simulation : simulations) sum += simulation->interventions();
  return sum;
}

}  // namespace

void Past::begin(Simulations present) {
  for (auto& moment : moments_) reuse(moment);
  moments_.clear();
  bytes_ = 0;
  keep(present);
  // What is far too large for the states of this scene would be memory that nobody counts.
  const auto size = moments_.back().states.front().bytes.size();
  std::erase_if(used_, [&](const std::string& memory) { return memory.capacity() > 2 * size; });
}

bool Past::changed(Simulations present) const {
  return moments_.empty() || interventions(present) != interventions_;
}

void Past::pass(Simulations present, double work) {
  work_ += work;
  if (work_ >= bounds_.apart) keep(present);
}

void Past::keep(Simulations present) {
  const Instant now{present.front()->steps(), present.front()->time()};
  while (!moments_.empty() && moments_.back().at.step > now.step) drop(moments_.end() - 1);
  const bool stepped = moments_.empty() || moments_.back().at.step < now.step;
  const bool intervened = changed(present);
  if (!stepped) {
    if (!intervened) return;
    work_ = moments_.back().work;
    drop(moments_.end() - 1);
  }
  moments_.push_back({now, work_, intervened, copies(present)});
  for (const auto& state : moments_.back().states) bytes_ += state.bytes.size();
  interventions_ = interventions(present);
  work_ = 0;
  make_room();
}

std::vector<Past::Moment::State> Past::copies(Simulations present) {
  std::vector<Moment::State> states;
  for (std::size_t k = 0; k < present.size(); ++k) {
    std::string memory;
    if (!used_.empty()) {
      memory = std::move(used_.back());
      used_.pop_back();
    }
    if (!moments_.empty()) memory.reserve(moments_.back().states[k].bytes.size());
    auto state = StateBytes::over(std::move(memory));
    present[k]->pass_state(state);
    states.push_back({present[k]->integrator(), std::move(state).take()});
  }
  return states;
}

void Past::drop(Moments::iterator moment) {
  for (const auto& state : moment->states) bytes_ -= state.bytes.size();
  reuse(*moment);
  moments_.erase(moment);
}

void Past::reuse(Moment& moment) {
  for (auto& state : moment.states) used_.push_back(std::move(state.bytes));
}

/// In the older half moments become rare, as far as the way between two of them remains short; then the
/// oldest goes.
void Past::make_room() {
  while (moments_.size() > 2 && (bytes_ > bounds_.bytes || moments_.size() > bounds_.moments)) {
    const auto middle = moments_.begin() + static_cast<std::ptrdiff_t>(moments_.size() / 2);
    auto needless = moments_.begin() + 1;
    while (needless != middle &&
           (needless->intervened || needless->work + (needless + 1)->work > bounds_.most_apart))
      ++needless;
    if (needless == middle) needless = moments_.begin();
    (needless + 1)->work += needless->work;
    drop(needless);
  }
}

Past::Instant Past::before(long step) const {
  const auto after = std::ranges::upper_bound(moments_, step, {}, [](const Moment& m) { return m.at.step; });
  return (after == moments_.begin() ? after : after - 1)->at;
}

Past::Instant Past::before(double time) const {
  const auto after = std::ranges::upper_bound(moments_, time, {}, [](const Moment& m) { return m.at.time; });
  return (after == moments_.begin() ? after : after - 1)->at;
}

void Past::restore(Simulations simulations, long step) {
  const long wanted = before(step).step;
  auto& moment = *std::ranges::lower_bound(moments_, wanted, {}, [](const Moment& m) { return m.at.step; });
  for (std::size_t k = 0; k < simulations.size(); ++k) {
    auto& [integrator, bytes] = moment.states.at(k);
    if (simulations[k]->integrator() != integrator) simulations[k]->use_integrator(integrator);
    StateBytes state(std::move(bytes));
    simulations[k]->pass_state(state);
    bytes = std::move(state).take();
  }
  interventions_ = interventions(simulations);
  work_ = 0;
}

}  // namespace clapotis
