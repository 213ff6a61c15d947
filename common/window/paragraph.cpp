#include "common/window/paragraph.hpp"

#include <algorithm>
#include <string>

#include "imgui.h"

namespace clapotis {
namespace {

float width(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

/// As much of a word as fits, up to a comma if there is one; all of it where nothing fits.
std::size_t fitting(std::string_view word, float room) {
  std::size_t end = word.size();
  while (end > 1 && width(std::string(word.substr(0, end))) > room) {
    const auto comma = word.rfind(',', end - 2);
    end = comma == std::string_view::npos || comma == 0 ? end - 1 : comma + 1;
  }
  return end > 1 ? end : word.size();
}

void one_paragraph(std::string_view sentence, float room) {
  std::string line;
  while (!sentence.empty()) {
    auto end = std::min(sentence.find(' ', 1), sentence.size());
    if (line.empty()) end = fitting(sentence.substr(0, end), room);
    const auto longer = line + std::string(sentence.substr(0, end));
    if (!line.empty() && width(longer) > room) {
      text(line);
      line.clear();
      while (sentence.starts_with(' ')) sentence.remove_prefix(1);
    } else {
      line = longer;
      sentence.remove_prefix(end);
      if (!sentence.starts_with(' ') && !sentence.empty()) {  // a word was cut
        text(line);
        line.clear();
      }
    }
  }
  text(line);
}

}  // namespace

void text(std::string_view words) { ImGui::TextUnformatted(words.data(), words.data() + words.size()); }

void paragraph(std::string_view text, float room) {
  for (;;) {
    const auto end = text.find("\n\n");
    one_paragraph(text.substr(0, end), room);
    if (end == std::string_view::npos) return;
    ImGui::Spacing();
    text.remove_prefix(end + 2);
  }
}

}  // namespace clapotis
