#include "common/simulation/parameters.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

std::string replace_length(std::string unit, std::string_view length_unit) {
  for (auto at = unit.find('L'); at != std::string::npos; at = unit.find('L', at + length_unit.size()))
    unit.replace(at, 1, length_unit);
  return unit;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& names) {
  const auto near = nearest(word, names);
  return near.empty() ? "" : say(words().did_you_mean, fmt::arg("name", near));
}

}  // namespace

std::string joined(const std::vector<std::string>& names, std::string_view between) {
  std::string text;
  for (const auto& name : names) text.append(text.empty() ? "" : between).append(name);
  return text;
}

void from_place(std::string_view place, const std::function<void()>& read) {
  try {
    read();
  } catch (const BadInput& error) {
    if (place.empty()) throw;
    throw BadInput(say(words().from_place, fmt::arg("place", place), fmt::arg("sentence", error.what())));
  }
}

std::string_view name_of(Origin origin) {
  constexpr std::string_view names[] = {"default", "scene", "file", "environment", "flag", "window"};
  return names[static_cast<std::size_t>(origin)];
}

bool Range::contains(double value) const {
  return std::isfinite(value) && (low_excluded ? value > low : value >= low) && value <= high;
}

std::string Range::text() const {
  const bool below = low > -std::numeric_limits<double>::max(),
             above = high < std::numeric_limits<double>::max();
  const auto fill = [&](std::string_view sentence) {
    return say(sentence, fmt::arg("low", to_text(low)), fmt::arg("high", to_text(high)));
  };
  if (!below && !above) return std::string(words().any_finite);
  if (!above) return fill(low_excluded ? words().range_above : words().range_at_least);
  if (!below) return fill(words().range_at_most);
  return fill(words().range_between);
}

std::string to_text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

double parse_number(std::string_view what, std::string_view text, std::string_view allowed) {
  const auto refuse = [&](std::string_view sentence) {
    throw BadInput(
        say(sentence, fmt::arg("name", what), fmt::arg("value", text), fmt::arg("allowed", allowed)));
  };
  double value = 0;
  const auto digits = text.starts_with('+') && !text.starts_with("+-") ? text.substr(1) : text;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (text.find(',') != std::string_view::npos) refuse(words().comma_for_dot);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
    refuse(words().not_a_number);
  return value;
}

std::string Parameter::text() const {
  if (!choices.empty()) return choices[static_cast<std::size_t>(value)];
  if (list) {
    std::vector<std::string> entries;
    for (const double entry : values) entries.push_back(to_text(entry));
    return entries.empty() ? "none" : joined(entries, ",");
  }
  return automatic && std::isnan(value) ? "auto" : to_text(value);
}

std::string Parameter::allowed() const {
  if (!choices.empty()) return joined(choices);
  const auto unit_text = unit.empty() ? "" : " " + unit;
  return range.text() + unit_text + form();
}

std::string Parameter::form() const {
  return std::string(automatic ? words().or_auto : list ? words().each_or_none : "");
}

double Parameter::parse(std::string_view text) const {
  if (!choices.empty()) {
    const auto found = std::find(choices.begin(), choices.end(), text);
    if (found != choices.end()) return static_cast<double>(found - choices.begin());
    throw BadInput(say(words().not_a_choice, fmt::arg("name", name), fmt::arg("value", text),
                       fmt::arg("allowed", allowed())) +
                   suggestion(text, choices));
  }
  if (automatic && text == "auto") return std::numeric_limits<double>::quiet_NaN();
  const double number = parse_number(name, text, allowed());
  const auto refuse = [&](std::string_view sentence) {
    throw BadInput(say(sentence, fmt::arg("name", name), fmt::arg("value", text),
                       fmt::arg("unit", unit.empty() ? "" : " " + unit), fmt::arg("allowed", allowed())));
  };
  if (!range.contains(number)) refuse(words().value_out_of_range);
  if (integer && number != std::floor(number)) refuse(words().not_an_integer);
  return number;
}

void Parameter::read(std::string_view text) {
  if (!list) {
    value = parse(text);
    return;
  }
  std::vector<double> entries;
  for (std::size_t at = 0; text != "none" && at <= text.size();) {
    const auto end = std::min(text.find(',', at), text.size());
    const double entry = parse(text.substr(at, end - at));
    if (std::find(entries.begin(), entries.end(), entry) != entries.end())
      throw BadInput(say(words().entry_twice, fmt::arg("name", name), fmt::arg("value", text),
                         fmt::arg("entry", to_text(entry))));
    entries.push_back(entry);
    at = end + 1;
  }
  values = std::move(entries);
}

Parameters::Parameters(std::string length_unit, Defaults defaults, Overrides overrides)
    : length_unit_(std::move(length_unit)),
      defaults_(std::move(defaults)),
      overrides_(std::move(overrides)) {}

Parameter* Parameters::entry(std::string_view name) {
  const auto found =
      std::find_if(table_.begin(), table_.end(), [&](const auto& p) { return p.name == name; });
  return found == table_.end() ? nullptr : &*found;
}

const Parameter* Parameters::find(std::string_view name) const {
  return const_cast<Parameters*>(this)->entry(name);
}

double Parameters::value(std::string_view name) const {
  if (const auto* p = find(name)) return p->value;
  throw std::logic_error("no law or scene has read the parameter " + std::string(name));
}

Parameter& Parameters::note(Parameter p) {
  if (auto* known = entry(p.name)) return *known;
  p.unit = replace_length(p.unit, length_unit_);
  if (const auto preset = defaults_.find(p.name); preset != defaults_.end()) {
    p.read(preset->second);
    p.origin = Origin::scene;
  }
  if (const auto given = overrides_.find(p.name); given != overrides_.end()) {
    const auto& [text, origin, place, unit] = given->second;
    if (p.derived) throw BadInput(say(words().derived_parameter, fmt::arg("name", p.name)));
    from_place(place, [&, &text = text, &unit = unit] {
      if (!unit.empty() && unit != p.unit)
        throw BadInput(say(words().other_unit, fmt::arg("name", p.name), fmt::arg("value", text),
                           fmt::arg("given", unit), fmt::arg("unit", p.unit)));
      p.read(text);
    });
    p.origin = origin;
  }
  table_.push_back(std::move(p));
  return table_.back();
}

double Parameters::number(const Parameter& p) { return note(p).value; }

long Parameters::integer(Parameter p) {
  p.integer = true;
  return static_cast<long>(note(std::move(p)).value);
}

std::string Parameters::choice(Parameter p) { return note(std::move(p)).text(); }

std::vector<double> Parameters::numbers(Parameter p) {
  p.list = true;
  return note(std::move(p)).values;
}

void Parameters::derive(Parameter p, double value) {
  p.derived = true;
  note(std::move(p)).value = value;
}

void Parameters::set(std::string_view name, std::string_view text, Origin origin) {
  auto* known = entry(name);
  if (known == nullptr) refuse_unknown(name);
  if (known->derived) throw BadInput(say(words().derived_parameter, fmt::arg("name", name)));
  known->read(text);
  known->origin = origin;
  overrides_.insert_or_assign(std::string(name), Override{std::string(text), origin});
}

void Parameters::reject_unknown() const {
  for (const auto& [name, given] : overrides_)
    if (find(name) == nullptr) from_place(given.place, [&, &name = name] { refuse_unknown(name); });
}

void Parameters::refuse_unknown(std::string_view name) const {
  std::vector<std::string> names;
  for (const auto& p : table_)
    if (!p.derived) names.push_back(p.name);
  throw BadInput(say(words().unknown_parameter, fmt::arg("name", name), fmt::arg("known", joined(names))) +
                 suggestion(name, names));
}

std::string unknown_name(std::string_view kind, std::string_view name,
                         const std::vector<std::string>& known) {
  return say(words().unknown_name, fmt::arg("kind", called(kind, Naming::kind)), fmt::arg("name", name),
             fmt::arg("known", known.empty() ? std::string(words().none) : joined(known))) +
         suggestion(name, known);
}

std::string nearest(std::string_view word, const std::vector<std::string>& names) {
  std::string best;
  std::size_t fewest = std::max<std::size_t>(2, word.size() / 2) + 1;
  for (const auto& name : names) {
    std::vector<std::size_t> row(name.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= word.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= name.size(); ++j) {
        const auto edit = diagonal + (word[i - 1] == name[j - 1] ? 0 : 1);
        diagonal = row[j];
        row[j] = std::min({edit, row[j] + 1, row[j - 1] + 1});
      }
    }
    if (row.back() < fewest) {
      fewest = row.back();
      best = name;
    }
  }
  if (!best.empty() || word.size() < 3) return best;
  for (const auto& name : names)  // "verlet" is far from "velocity_verlet", and yet
    if (name.find(word) != std::string::npos) return name;
  return best;
}

}  // namespace clapotis
