#include <fmt/core.h>
#include <charconv>

#include <algorithm>
#include <sstream>

#include "common/lesson/lesson.hpp"

namespace clapotis {
namespace {

/// The lines of one text. Its sentences name it and the line.
class Reader {
 public:
  Reader(std::string_view name, std::string_view text) : name_(name) {
    for (std::size_t at = 0; at < text.size();) {
      const auto end = std::min(text.find('\n', at), text.size());
      lines_.push_back(text.substr(at, end - at));
      at = end + 1;
    }
  }

  [[nodiscard]] bool ends() const { return at_ >= lines_.size(); }
  [[nodiscard]] std::string_view line() const { return lines_[at_]; }
  [[nodiscard]] int number() const { return static_cast<int>(at_) + 1; }
  void next() { ++at_; }

  [[noreturn]] void refuse(int line, std::string_view sentence) const {
    throw LessonError(fmt::format("{}, line {}: {}", name_, line, sentence));
  }
  [[noreturn]] void refuse(std::string_view sentence) const { refuse(number(), sentence); }

 private:
  std::string_view name_;
  std::vector<std::string_view> lines_;
  std::size_t at_ = 0;
};

bool begins_section(std::string_view line) { return line.starts_with("**") || line.starts_with("#"); }

/// Lines belong together until an empty one; what begins and ends the text is not empty.
std::string paragraphs(Reader& reader, std::string_view first) {
  std::string text(first);
  bool parted = false;
  for (; !reader.ends() && !begins_section(reader.line()); reader.next()) {
    if (reader.line().starts_with("```")) reader.refuse("only **Run.** has a block of commands");
    if (reader.line().empty()) {
      parted = true;
      continue;
    }
    text += text.empty() ? "" : parted ? "\n\n" : " ";
    text += reader.line();
    parted = false;
  }
  return text;
}

/// What stands behind **Mark.** in the line that begins with it, which is left behind.
std::string_view enter(Reader& reader, std::string_view mark) {
  while (!reader.ends() && reader.line().empty()) reader.next();
  const auto wanted = fmt::format("**{}.**", mark);
  if (reader.ends() || !reader.line().starts_with(wanted))
    reader.refuse(fmt::format("here {} is expected: an exercise has its parts in a fixed order", wanted));
  auto rest = reader.line().substr(wanted.size());
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  reader.next();
  return rest;
}

/// Without the marks of code and links: [Stage 3](../README.md) is Stage 3.
std::string plain(std::string text) {
  std::erase(text, '`');
  for (auto at = text.find("]("); at != std::string::npos; at = text.find("](", at)) {
    text.erase(at, text.find(')', at) + 1 - at);
    if (const auto start = text.rfind('[', at); start != std::string::npos) text.erase(start, 1);
  }
  return text;
}

std::string section(Reader& reader, std::string_view mark) {
  const auto first = enter(reader, mark);
  const int line = reader.number() - 1;
  auto text = plain(paragraphs(reader, first));
  if (text.empty()) reader.refuse(line, fmt::format("**{}.** says nothing", mark));
  return text;
}

/// "### 2. Half the step", the second of the exercises.
std::string title(Reader& reader, std::size_t number) {
  const auto beginning = fmt::format("### {}. ", number);
  if (!reader.line().starts_with(beginning) || reader.line().size() == beginning.size())
    reader.refuse(fmt::format("here \"{}Title\" is expected", beginning));
  std::string text(reader.line().substr(beginning.size()));
  reader.next();
  return text;
}

std::vector<std::string> words_of(std::string_view line) {
  std::istringstream stream{std::string(line)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

LessonRun read_run(std::string_view line, int number) {
  LessonRun run{.text = std::string(line), .words = words_of(line), .stage = {}, .line = number};
  auto& words = run.words;
  const auto drop = [&](std::ptrdiff_t count) { words.erase(words.begin(), words.begin() + count); };
  if (words.size() >= 3 && words[0] == "./lab" && words[1] == "run") {
    run.kind = LessonRun::Kind::run;
    run.stage = words[2];
    drop(3);
  } else if (words.size() >= 4 && words[0] == "./lab" && words[1] == "compare") {
    run.kind = LessonRun::Kind::compare;
    drop(2);
  }
  return run;
}

std::vector<LessonRun> read_runs(Reader& reader) {
  const int start = reader.number();
  static_cast<void>(enter(reader, "Run"));
  while (!reader.ends() && !reader.line().starts_with("```") && !begins_section(reader.line())) reader.next();
  std::vector<LessonRun> runs;
  if (reader.ends() || !reader.line().starts_with("```"))
    reader.refuse(start, "**Run.** needs a block of commands between two lines ```");
  for (reader.next(); !reader.ends() && reader.line() != "```"; reader.next())
    runs.push_back(read_run(reader.line(), reader.number()));
  if (reader.ends()) reader.refuse(start, "the block of commands does not end");
  reader.next();
  if (runs.empty()) reader.refuse(start, "the block of commands is empty");
  while (!reader.ends() && !begins_section(reader.line())) reader.next();
  return runs;
}

/// The words of a check, taken one after the other.
class Sentence {
 public:
  Sentence(const Reader& reader, std::string_view text) : reader_(reader), words_(words_of(text)) {}

  [[nodiscard]] bool is(std::string_view word) const { return at_ < words_.size() && words_[at_] == word; }
  [[nodiscard]] bool ends() const { return at_ == words_.size(); }
  bool take(std::string_view word) {
    const bool there = is(word);
    if (there) ++at_;
    return there;
  }
  void demand(std::string_view word) {
    if (!take(word)) refuse(fmt::format("\"{}\" is expected{}", word, here()));
  }
  std::string word(std::string_view what) {
    if (ends()) refuse(fmt::format("{} is missing", what));
    return words_[at_++];
  }
  double number(std::string_view what) {
    const auto text = word(what);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      refuse(fmt::format("{} should be a number, not \"{}\"", what, text));
    return value;
  }
  [[noreturn]] void refuse(const std::string& sentence) const {
    reader_.refuse(sentence + "; the form is \"- run 1 at t = 0.4 s: error = 5.3e-3 m within 5 %\"");
  }

 private:
  [[nodiscard]] std::string here() const {
    return ends() ? std::string(" at the end") : fmt::format(" where \"{}\" stands", words_[at_]);
  }

  const Reader& reader_;
  std::vector<std::string> words_;
  std::size_t at_ = 0;
};

/// The colon is a word of its own.
std::string part_colon(std::string_view line) {
  std::string text(line);
  if (const auto colon = text.find(':'); colon != std::string::npos) text.replace(colon, 1, " : ");
  return text;
}

Check read_check(const Reader& reader) {
  Check check;
  check.line = reader.number();
  Sentence sentence(reader, part_colon(reader.line().substr(2)));
  sentence.demand("run");
  const double run = sentence.number("the number of the run");
  if (run < 1) sentence.refuse("runs are counted from 1");
  check.run = static_cast<std::size_t>(run) - 1;
  if (sentence.is("left") || sentence.is("right")) check.side = sentence.word("the side");
  if (sentence.take("at")) {
    sentence.demand("t");
    sentence.demand("=");
    check.time = sentence.number("the time");
    sentence.demand("s");
  }
  sentence.demand(":");
  check.quantity = sentence.word("the quantity");
  const auto relation = sentence.word("=, < or >");
  if (relation != "=" && relation != "<" && relation != ">") sentence.refuse("=, < or > is expected");
  check.relation = relation == "="   ? Check::Relation::equal
                   : relation == "<" ? Check::Relation::below
                                     : Check::Relation::above;
  check.value = sentence.number("the value");
  while (!sentence.ends() && !sentence.is("within"))
    check.unit += (check.unit.empty() ? "" : " ") + sentence.word("the unit");
  if (sentence.take("within")) {
    if (relation != "=") sentence.refuse("only = has a tolerance");
    check.tolerance = sentence.number("the tolerance") / 100;
    sentence.demand("%");
  }
  if (!sentence.ends()) sentence.refuse("this says more than a check can");
  return check;
}

void refuse_without_run(const Reader& reader, const Check& check, const std::vector<LessonRun>& runs) {
  if (check.run >= runs.size())
    reader.refuse(check.line, fmt::format("there is no run {}, but {}", check.run + 1, runs.size()));
  const auto kind = runs[check.run].kind;
  if (kind == LessonRun::Kind::other)
    reader.refuse(check.line, fmt::format("run {} is neither ./lab run nor ./lab compare", check.run + 1));
  if (kind == LessonRun::Kind::run && !check.side.empty())
    reader.refuse(check.line, fmt::format("run {} has no {} side", check.run + 1, check.side));
}

std::vector<Check> read_checks(Reader& reader, const std::vector<LessonRun>& runs) {
  const int start = reader.number();
  static_cast<void>(enter(reader, "Check"));
  std::vector<Check> checks;
  for (; !reader.ends() && !begins_section(reader.line()); reader.next()) {
    if (reader.line().empty()) continue;
    if (!reader.line().starts_with("- ")) reader.refuse("a check begins with \"- run\"");
    checks.push_back(read_check(reader));
    refuse_without_run(reader, checks.back(), runs);
  }
  if (checks.empty()) reader.refuse(start, "an exercise needs a check");
  return checks;
}

/// Goes behind the heading of the exercises; a text may stand above and below them.
void find_exercises(Reader& reader, std::string_view heading) {
  while (!reader.ends() && reader.line() != heading) reader.next();
  if (reader.ends()) reader.refuse(fmt::format("there is no \"{}\"", heading));
  reader.next();
}

/// Whether another exercise follows; "## " begins what comes behind them.
bool goes_on(Reader& reader) {
  while (!reader.ends() && reader.line().empty()) reader.next();
  return !reader.ends() && !reader.line().starts_with("## ");
}

}  // namespace

std::vector<Exercise> read_lesson(std::string_view readme, std::string_view french) {
  Reader reader("README.md", readme), translation("exercises.fr.md", french);
  find_exercises(reader, "## Predict, run, explain");
  find_exercises(translation, "## Prévoir, lancer, expliquer");
  std::vector<Exercise> exercises;
  while (goes_on(reader)) {
    Exercise exercise;
    auto& [english_words, french_words] = exercise.in;
    const auto number = exercises.size() + 1;
    english_words.title = title(reader, number);
    english_words.predict = section(reader, "Predict");
    exercise.runs = read_runs(reader);
    exercise.checks = read_checks(reader, exercise.runs);
    english_words.explain = section(reader, "Explain");
    if (!goes_on(translation))
      translation.refuse(fmt::format("exercise {}, \"{}\", has no translation", number, english_words.title));
    french_words.title = title(translation, number);
    french_words.predict = section(translation, "Prévoir");
    french_words.explain = section(translation, "Expliquer");
    exercises.push_back(std::move(exercise));
  }
  if (goes_on(translation)) translation.refuse("the README has no such exercise");
  return exercises;
}

}  // namespace clapotis
