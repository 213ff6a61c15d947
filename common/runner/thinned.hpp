#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace clapotis {

/// What comes one after the other, in bounded memory: when it is full, every second goes, and from then on
/// only every second one comes.
template <class Sample>
class Thinned {
 public:
  void add(const Sample& sample) {
    if (count_++ % stride_ != 0) return;
    kept_.push_back(sample);
    if (kept_.size() < most) return;
    for (std::size_t k = 0; 2 * k < kept_.size(); ++k) kept_[k] = kept_[2 * k];
    kept_.resize((kept_.size() + 1) / 2);
    stride_ *= 2;
  }
  void replace(std::vector<Sample> kept) { kept_ = std::move(kept); }
  [[nodiscard]] const std::vector<Sample>& kept() const { return kept_; }

 private:
  static constexpr std::size_t most = 4096;
  std::vector<Sample> kept_;
  long count_ = 0, stride_ = 1;
};

}  // namespace clapotis
