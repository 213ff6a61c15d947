#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace clapotis {

/// What the user can see change, one line per change ("paused", "step 12", "parameter gravity=300"), an empty
/// line after those of one frame, written to the file CLAPOTIS_TRACE names: this is how the window tests
/// await instead of sleeping. A line waits until the frame after the one it was said in is on the screen, for
/// a panel may need one more frame to arrange itself: whoever reads the line may look at the picture and
/// click on it.
class Trace {
 public:
  Trace();   ///< silent when CLAPOTIS_TRACE is not set
  ~Trace();  ///< writes what is left
  Trace(const Trace&) = delete;
  Trace& operator=(const Trace&) = delete;

  [[nodiscard]] bool active() const { return file_.is_open(); }
  void say(std::string line);
  /// Where a control is: not to be awaited, so it goes out with the next flush.
  void place(const std::string& line);
  /// Call when a frame is on the screen.
  void flush();

 private:
  std::ofstream file_;
  std::vector<std::string> said_, settled_;
};

}  // namespace clapotis
