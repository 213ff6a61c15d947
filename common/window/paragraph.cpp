#include "common/window/paragraph.hpp"

#include <algorithm>
#include <string>

#include "imgui.h"

namespace clapotis {
namespace {

void one_paragraph(std::string_view sentence, float room) {
  std::string line;
  while (!sentence.empty()) {
    const auto end = std::min(sentence.find(' ', 1), sentence.size());
    const auto longer = line + std::string(sentence.substr(0, end));
    if (!line.empty() && ImGui::CalcTextSize(longer.c_str()).x > room) {
      ImGui::TextUnformatted(line.c_str());
      line = sentence.substr(1, end - 1);
    } else {
      line = longer;
    }
    sentence.remove_prefix(end);
  }
  ImGui::TextUnformatted(line.c_str());
}

}  // namespace

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
