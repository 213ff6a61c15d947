#pragma once

#include <array>
#include <optional>
#include <string>

#include "common/window/window_state.hpp"

namespace clapotis {

/// A field in which the value of something is typed, as long as `WindowState::typing` names it.
class TypedText {
 public:
  /// Begins with that text, all of it selected, for what is called `name`.
  void begin(WindowState& state, const std::string& name, const std::string& text);
  /// The field itself; what was entered now. Ends the typing then, and when the user has gone elsewhere.
  [[nodiscard]] std::optional<std::string> lay_out(WindowState& state, const char* label);

 private:
  std::array<char, 256> text_{};
  bool focus_ = false;  ///< the field has just appeared
};

}  // namespace clapotis
