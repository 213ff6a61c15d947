#include "common/runner/language_option.hpp"

#include <cstdlib>
#include <optional>
#include <string_view>

#include "common/language.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

Language of_environment() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') continue;
    return std::string_view(value).starts_with("fr") ? Language::french : Language::english;
  }
  return Language::english;
}

/// The last that is given counts, as of every option.
std::optional<std::string_view> asked_for(int argc, const char* const* argv) {
  constexpr std::string_view option = "--lang", with_value = "--lang=";
  std::optional<std::string_view> asked;
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    if (word.starts_with(with_value)) asked = word.substr(with_value.size());
    if (word == option && k + 1 < argc && !std::string_view(argv[k + 1]).starts_with("--")) asked = argv[++k];
  }
  return asked;
}

}  // namespace

void choose_language(int argc, const char* const* argv) {
  speak(of_environment());
  const auto asked = asked_for(argc, argv);
  if (!asked) return;
  if (asked != "en" && asked != "fr")
    throw BadInput(say(words().not_a_choice, fmt::arg("name", "lang"), fmt::arg("value", *asked),
                       fmt::arg("allowed", "en, fr")));
  speak(*asked == "fr" ? Language::french : Language::english);
}

}  // namespace clapotis
