#pragma once

#include <array>
#include <map>
#include <string>

#include "common/window/trace.hpp"

namespace clapotis {

/// Tells the trace where ImGui put a control, whenever that changes, so that a test can click on it.
class Controls {
 public:
  explicit Controls(Trace& trace) : trace_(trace) {}
  /// Names the item that was laid out last.
  void name_last(const std::string& name);

 private:
  Trace& trace_;
  std::map<std::string, std::array<int, 4>> places_;
};

}  // namespace clapotis
