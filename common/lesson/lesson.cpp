#include "common/lesson/lesson.hpp"

#include <cmath>

#include "common/lesson/texts.hpp"
#include "common/words.hpp"

namespace clapotis {

bool Check::holds(double measured) const {
  if (relation == Relation::below) return measured < value;
  if (relation == Relation::above) return measured > value;
  return std::abs(measured - value) <= tolerance * std::abs(value);
}

std::string LessonRun::summary() const {
  if (kind != Kind::run) return text;
  std::string all, end;
  const auto add = [&](const std::string& part) { all += (all.empty() ? "" : ", ") + part; };
  for (std::size_t k = 0; k < words.size(); ++k) {
    const auto& word = words[k];
    const auto value = k + 1 < words.size() ? words[k + 1] : std::string();
    if (!word.starts_with("--")) {
      add(word);
      continue;
    }
    if (word == "--headless") continue;  // what follows has a value
    ++k;
    if (word == "--set" || word == "--integrator" || word == "--preset") add(value);
    if (word == "--until") end = "t\u00a0=\u00a0" + value + "\u00a0s";
    if (word == "--steps") end = say(clapotis::words().lesson.steps, fmt::arg("count", value));
  }
  if (!end.empty()) add(end);
  return all;
}

const std::vector<Exercise>& lesson_of(std::string_view stage) {
  static const std::vector<Exercise> none;
  static const auto lessons = [] {
    std::vector<std::pair<std::string_view, std::vector<Exercise>>> all;
    for (const auto& text : lesson_texts())
      all.emplace_back(text.stage, read_lesson(text.readme, text.french));
    return all;
  }();
  for (const auto& [name, exercises] : lessons)
    if (name == stage) return exercises;
  return none;
}

}  // namespace clapotis
