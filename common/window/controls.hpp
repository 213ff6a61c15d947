#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "common/runner/canvas.hpp"
#include "common/window/trace.hpp"

namespace clapotis {

/// Tells the trace where ImGui put a control, whenever that changes, so that a test can click on it.
class Controls {
 public:
  explicit Controls(Trace& trace) : trace_(trace) {}
  /// Names the item that ImGui laid out last.
  void name_last(const std::string& name);
  void name(const std::string& name, const Box& place);
  /// A button of that name, `width` pixels wide; 0: as wide as its label. Whether it was pressed now.
  bool button(const std::string& name, std::string_view label, float width = 0);

 private:
  Trace& trace_;
  std::map<std::string, std::array<int, 4>> places_;
};

}  // namespace clapotis
