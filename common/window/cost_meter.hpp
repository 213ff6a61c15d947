#pragma once

#include "common/window/session.hpp"

namespace clapotis {

/// What the run costs, over the last half second or so: numbers that stand still long enough to be read.
class CostMeter {
 public:
  struct Rates {
    double step_milliseconds = 0;  ///< of real time; of the last steps when none was taken since
    double frames_per_second = 0;
    double frame_milliseconds = 0;  ///< our own processor time for painting one frame
    double speed = 0;               ///< simulated seconds per second
    double possible_speed = 0;      ///< simulated seconds per second of computing
    bool slower_than_asked = false;
    std::optional<PairCount> pairs;
  };

  /// One frame: `elapsed` seconds after the last one, `painting` seconds of processor time for it.
  void frame(Session& session, double elapsed, double painting);
  [[nodiscard]] const Rates& rates() const { return rates_; }

 private:
  Rates rates_;
  double elapsed_ = 0, painting_ = 0, stepping_ = 0, simulated_ = 0;
  long frames_ = 0, steps_ = 0, starts_ = -1, counted_at_ = -1;
  bool late_ = false;
};

}  // namespace clapotis
