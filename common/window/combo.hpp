#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/window/controls.hpp"
#include "common/window/window_state.hpp"

namespace clapotis {

/// A list that opens, `width` pixels wide; the place of the name that was chosen now. Its entries are known
/// to the trace as NAME:ENTRY.
std::optional<std::size_t> combo(WindowState& state, Controls& controls, const std::string& name,
                                 const std::vector<std::string>& names, const std::string& present,
                                 float width);

}  // namespace clapotis
