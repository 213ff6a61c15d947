#pragma once

#include <string_view>

namespace clapotis {

/// A bar with the time left, on standard error, only when that is a terminal. Without colour where NO_COLOR
/// asks so.
class Progress {
 public:
  explicit Progress(bool wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Draws the bar again, ten times a second at most. `share` is what is done, 0 to 1; `time` is simulated
  /// [s], and `what` that which is being done.
  void show(double share, double time);
  void show(double share, std::string_view what);

 private:
  bool wanted_, coloured_, drawn_ = false;
  double start_, last_ = 0;
};

}  // namespace clapotis
