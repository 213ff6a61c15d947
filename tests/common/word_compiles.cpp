// Compiled by CTest alone, with FRENCH set to the French words, to see what the compiler says of them.
#include "common/word.hpp"

namespace clapotis {

struct Words {
  Word greeting, farewell;
  constexpr bool operator==(const Words&) const = default;
};

constexpr Words english{.greeting = "Good day, {name}: {weather}", .farewell = "Goodbye"};
constexpr Words french{FRENCH};
static_assert(english == french);

}  // namespace clapotis
