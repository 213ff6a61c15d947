#include "common/runner/environment.hpp"

#include <unistd.h>

#include <algorithm>
#include <string_view>

namespace clapotis {

std::vector<Variable> environment() {
  constexpr std::string_view prefix = "CLAPOTIS_";
  std::vector<Variable> found;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const auto equals = text.find('=');
    if (!text.starts_with(prefix) || equals == std::string_view::npos) continue;
    std::string name(text.substr(prefix.size(), equals - prefix.size()));
    for (char& letter : name)
      if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    if (name == "trace") continue;  // the window's
    found.push_back({std::string(text.substr(0, equals)), name, std::string(text.substr(equals + 1))});
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return found;
}

}  // namespace clapotis
