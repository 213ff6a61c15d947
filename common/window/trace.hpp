#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace clapotis {

/// What the user can see change, one line per change ("paused", "step 12", "parameter gravity=300"), written
/// to the file CLAPOTIS_TRACE names. Lines wait for `flush`, which the window calls once the frame that shows
/// them is on the screen: whoever reads a line may look at the picture. This is how the window tests await
/// instead of sleeping.
class Trace {
 public:
  Trace();  ///< silent when CLAPOTIS_TRACE is not set
  [[nodiscard]] bool active() const { return file_.is_open(); }
  void say(std::string line);
  void flush();

 private:
  std::ofstream file_;
  std::vector<std::string> lines_;
};

}  // namespace clapotis
