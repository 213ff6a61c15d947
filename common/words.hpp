#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>

namespace clapotis {

/// Every word that the window and the command line show, in one language. A hole is written {name}; a
/// language that lacks a word does not compile.
struct Words {
  // what a user gave and cannot be used
  std::string_view unknown_parameter, unknown_name, did_you_mean, value_out_of_range, not_a_number,
      not_an_integer, not_a_choice, comma_for_dot, derived_parameter, too_many_discs, box_too_small,
      outside_box, no_time_step, threads_out_of_range;
  // ranges of values
  std::string_view any_finite, range_above, range_at_least, range_at_most, range_between, or_auto;
  // what a run says
  std::string_view diverged, diverged_speed, diverged_nan, cause_limit, cause_scheme, beyond_limit,
      warn_coincident, warn_folded;
};

/// The words of the language in use.
const Words& words();

/// The words with their holes filled: say(words().not_a_number, fmt::arg("value", text)).
template <class... Args>
std::string say(std::string_view sentence, const Args&... args) {
  return fmt::format(fmt::runtime(sentence), args...);
}

/// What a quantity is called in the panel and the help: "gravity" gives "weight per unit of mass". The name
/// itself when the table has no line for it, so that a new law needs none.
std::string_view meaning(std::string_view name);

}  // namespace clapotis
