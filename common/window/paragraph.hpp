#pragma once

#include <string_view>

namespace clapotis {

/// Text in lines no wider than `room` [pixel], broken at spaces only: ImGui would also break a number at its
/// dot. An empty line parts paragraphs.
void paragraph(std::string_view text, float room);

}  // namespace clapotis
