#pragma once

#include <string_view>

namespace clapotis {

/// One line, as it stands.
void text(std::string_view words);
/// Text in lines no wider than `room` [pixel], broken at spaces only, as ImGui would also break a number at
/// its dot; a word that is longer than a line breaks at a comma. An empty line parts paragraphs.
void paragraph(std::string_view text, float room);

}  // namespace clapotis
