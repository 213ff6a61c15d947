#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace clapotis {

/// A word or a sentence that a user reads, in one language. A hole in it is written {name}. It cannot be made
/// from nothing, so a language that lacks one does not compile.
class Word {
 public:
  constexpr Word(const char* text) : text_(text) {}
  constexpr operator std::string_view() const { return text_; }

 private:
  friend struct Words;

  static constexpr std::size_t most_holes = 16;

  /// The names of the holes, in the order of the alphabet, each once, behind empty ones.
  [[nodiscard]] constexpr std::array<std::string_view, most_holes> holes() const {
    std::array<std::string_view, most_holes> names{};
    std::size_t count = 0;
    for (auto at = text_.find('{'); at != std::string_view::npos; at = text_.find('{', at + 1)) {
      const auto name = text_.substr(at + 1, text_.find('}', at) - at - 1);
      if (std::find(names.begin(), names.end(), name) == names.end()) names.at(count++) = name;
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  /// French sets a no-break space (U+00A0) before : ; ? ! % and inside guillemets.
  [[nodiscard]] constexpr bool breaks_before_a_sign() const {
    for (const char* sign : {" :", " ;", " ?", " !", " %", " »", "« "})
      if (text_.find(sign) != std::string_view::npos) return true;
    return false;
  }

  /// Compares an English word with its French one, for all members of Words at once: never false, but what is
  /// wrong is no constant expression, and the compiler says which member it is and what is wrong with it.
  constexpr bool operator==(const Word& french) const {
    if (text_.empty() || french.text_.empty()) throw "a word is empty in one of the languages";
    if (holes() != french.holes()) throw "the French sentence has other {holes} than the English one";
    if (french.breaks_before_a_sign()) throw "French has a no-break space before : ; ? ! % and inside « »";
    return true;
  }

  std::string_view text_;
};

}  // namespace clapotis
