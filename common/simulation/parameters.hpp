#pragma once

#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace clapotis {

/// Where a value comes from; a later one wins.
enum class Origin { law, scene, file, environment, flag, window };
std::string_view name_of(Origin origin);

/// Whether a change takes effect in a running simulation, or starts the scene anew.
enum class Change { live, restart };

/// The values a number may take.
struct Range {
  double low = -std::numeric_limits<double>::max(), high = std::numeric_limits<double>::max();
  bool low_excluded = false;

  [[nodiscard]] bool contains(double value) const;
  /// For example "> 0", "0 to 1", ">= 0", "any finite number".
  [[nodiscard]] std::string text() const;
};
inline constexpr Range any_number{};
inline constexpr Range positive{.low = 0, .low_excluded = true};
inline constexpr Range not_negative{.low = 0};

/// A parameter of a scene, as written once by the law or the scene that uses it. In `unit`, L stands for the
/// scene's unit of length (px or m). A choice has `choices` and its value is the place in that list; an
/// integer takes whole numbers; `automatic` also takes the word "auto" (value NaN, computed by the program).
/// A list has `values`, each in `range` and no two alike, written 0.1,0.5 or "none".
struct Parameter {
  std::string name, symbol, unit;
  double value = 0;
  Range range = any_number;
  Change change = Change::live;
  bool integer = false;
  bool automatic = false;
  std::vector<std::string> choices = {};
  bool list = false;
  std::vector<double> values = {};
  bool derived = false;  ///< a result of other parameters: shown and recorded, never set
  Origin origin = Origin::law;

  [[nodiscard]] std::string text() const;     ///< the value as a user would type it
  [[nodiscard]] std::string allowed() const;  ///< the allowed values with the unit, for a sentence
  [[nodiscard]] std::string form() const;     ///< what a number may be beside its range: "" or ", or auto"
  /// Of one value. Throws BadInput: what, where, value, range, unit.
  [[nodiscard]] double parse(std::string_view text) const;
  /// Takes what a user types, one value or a list; throws BadInput, and changes nothing then.
  void read(std::string_view text);
};

/// Values given by the user, by name; not yet checked.
struct Override {
  std::string text;
  Origin origin = Origin::flag;
  std::string place = {};  ///< the file or variable it stands in, for a sentence
  std::string unit = {};   ///< the unit it was written with, if any
};
using Overrides = std::map<std::string, Override, std::less<>>;

/// A scene's own defaults, by name, as a user would type them.
using Defaults = std::map<std::string, std::string, std::less<>>;

/// The parameters of one scene. They come to be by being read: a law or a scene states name, symbol, unit,
/// default and range where it needs the value, and gets the default, the scene's own default or the user's
/// value back. That one statement also feeds the panel, the command line, the files and the checks.
class Parameters {
 public:
  Parameters(std::string length_unit, Defaults defaults, Overrides overrides);

  /// The value of `p`, which is noted when it is new. Throws BadInput when the user's value is not allowed.
  double number(const Parameter& p);
  long integer(Parameter p);
  /// The chosen word, one of `p.choices`; the default is the first, or the scene's.
  std::string choice(Parameter p);
  /// The numbers of a list; none unless the scene or the user names some.
  std::vector<double> numbers(Parameter p);
  /// Notes a result of other parameters.
  void derive(Parameter p, double value);

  /// Changes one value as a user would; throws BadInput for an unknown name or a value that is not allowed,
  /// and changes nothing then.
  void set(std::string_view name, std::string_view text, Origin origin);

  /// Throws BadInput when the user named a parameter that the scene does not have.
  void reject_unknown() const;

  [[nodiscard]] const std::deque<Parameter>& all() const { return table_; }
  [[nodiscard]] const Parameter* find(std::string_view name) const;
  /// The value of a parameter that has been read before; throws std::logic_error where the scene has none
  /// such.
  [[nodiscard]] double value(std::string_view name) const;
  [[nodiscard]] const std::string& length_unit() const { return length_unit_; }
  /// What the user asked for, changes in the window included: what a reset starts from.
  [[nodiscard]] const Overrides& overrides() const { return overrides_; }

 private:
  Parameter& note(Parameter p);
  Parameter* entry(std::string_view name);
  [[noreturn]] void refuse_unknown(std::string_view name) const;

  std::string length_unit_;
  Defaults defaults_;
  Overrides overrides_;
  std::deque<Parameter> table_;
};

/// The name in `names` that is the fewest edits away from `word`, or that contains it; empty when none is
/// near.
std::string nearest(std::string_view word, const std::vector<std::string>& names);

/// The names in a row.
std::string joined(const std::vector<std::string>& names, std::string_view between = ", ");

/// "there is no KIND NAME; there is: ...", with the nearest of the known names.
std::string unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string>& known);

/// Calls `read`; a BadInput of it then names the file or variable in which the value stands.
void from_place(std::string_view place, const std::function<void()>& read);

/// The shortest text that reads back as the same number; always with a dot.
std::string to_text(double value);

/// A finite number written with a dot; throws BadInput naming `what` and what is `allowed` otherwise.
double parse_number(std::string_view what, std::string_view text, std::string_view allowed);

}  // namespace clapotis
