#include "report/studies/table.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "common/runner/atomic_file.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis::studies {
namespace {

constexpr std::string_view builds_line = "# builds:";

std::string joined(const Row& cells) {
  std::string line;
  for (const auto& each : cells) line += (line.empty() ? "" : ",") + each;
  return line + '\n';
}

Row cells_of(const std::string& line) {
  Row cells;
  std::istringstream stream(line);
  for (std::string each; std::getline(stream, each, ',');) cells.push_back(each);
  if (line.ends_with(',')) cells.emplace_back();
  return cells;
}

}  // namespace

std::string cell(double value) { return std::isfinite(value) ? to_text(value) : "nan"; }

std::string rounded(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  if (const double size = std::abs(value); size >= std::pow(10, digits) && size < 1e5) {
    const double unit = std::pow(10, std::floor(std::log10(size)) - digits + 1);
    return fmt::format("{:.0f}", std::round(value / unit) * unit);  // 1230, not 1.23e+03
  }
  auto text = fmt::format("{:#.{}g}", value, digits);  // # keeps the zeros: 1.50
  const auto dot = text.find('.');
  const auto whole = dot - (value < 0 ? 1 : 0);
  if (text.find('e') == std::string::npos && whole >= static_cast<std::size_t>(digits)) text.resize(dot);
  return text;
}

Table::Table(std::vector<Column> keys, std::vector<Column> values) : columns_(std::move(keys)) {
  columns_.insert(columns_.end(), std::make_move_iterator(values.begin()),
                  std::make_move_iterator(values.end()));
  columns_.push_back({"outcome", ""});
}

void Table::add(Row row) {
  if (row.size() != columns_.size()) throw std::logic_error("a row has other columns than its study");
  for (const auto& each : row)
    if (each.find_first_of(",\n\"") != std::string::npos) throw std::logic_error("a cell of a CSV: " + each);
  rows_.push_back(std::move(row));
}

std::vector<Row> Table::of(const Row& key) const {
  std::vector<Row> found;
  std::copy_if(rows_.begin(), rows_.end(), std::back_inserter(found),
               [&](const Row& row) { return std::equal(key.begin(), key.end(), row.begin()); });
  return found;
}

Table Table::with(const std::vector<std::vector<Row>>& points) const {
  Table other = *this;
  other.rows_.clear();
  for (const auto& rows : points)
    for (const auto& row : rows) other.add(row);
  return other;
}

void Table::note_build(const std::string& fingerprint) {
  if (std::find(builds_.begin(), builds_.end(), fingerprint) == builds_.end()) builds_.push_back(fingerprint);
}

std::size_t Table::place(std::string_view column) const {
  const auto found =
      std::find_if(columns_.begin(), columns_.end(), [&](const Column& each) { return each.name == column; });
  if (found == columns_.end()) throw std::logic_error("no column " + std::string(column));
  return static_cast<std::size_t>(found - columns_.begin());
}

const std::string& Table::text(const Row& row, std::string_view column) const {
  return row.at(place(column));
}

double Table::number(const Row& row, std::string_view column) const {
  const auto& text = this->text(row, column);
  return text == "nan" ? std::nan("") : parse_number(column, text, "a number");
}

std::vector<Row> Table::where(Cells cells) const {
  std::vector<Row> found;
  std::copy_if(rows_.begin(), rows_.end(), std::back_inserter(found), [&](const Row& row) {
    return std::all_of(cells.begin(), cells.end(),
                       [&](const auto& wanted) { return text(row, wanted.first) == wanted.second; });
  });
  return found;
}

std::vector<double> Table::numbers(const std::vector<Row>& rows, std::string_view column) const {
  std::vector<double> all;
  for (const auto& row : rows) all.push_back(number(row, column));
  return all;
}

std::vector<std::string> Table::kinds(std::string_view column) const {
  std::vector<std::string> all;
  for (const auto& row : rows_)
    if (std::find(all.begin(), all.end(), text(row, column)) == all.end()) all.push_back(text(row, column));
  return all;
}

/// What is to be the same when a table is read again.
std::string Table::head(const std::string& about) const {
  std::string text;
  std::istringstream lines(about);
  for (std::string line; std::getline(lines, line);) text += "# " + line + '\n';
  text += "# units:";
  for (const auto& column : columns_)
    if (!column.unit.empty()) text += ' ' + column.name + " [" + column.unit + ']';
  return text + '\n';
}

std::string Table::names() const {
  Row names;
  for (const auto& column : columns_) names.push_back(column.name);
  return joined(names);
}

std::string Table::csv(const std::string& about) const {
  auto text = head(about) + std::string(builds_line);
  for (const auto& build : builds_) text += ' ' + build;
  text += '\n' + names();
  for (const auto& row : rows_) text += joined(row);
  return text;
}

void Table::read(const std::filesystem::path& file, const std::string& about) {
  std::ifstream stream(file);
  if (!stream) refuse_file(words().cannot_read, file, errno);
  std::string line;
  const auto compare = [&](const std::string& wanted) {
    if (line != wanted)
      throw BadInput(say(words().study.other_table, fmt::arg("file", file.string()), fmt::arg("has", line),
                         fmt::arg("wanted", wanted)));
  };
  std::istringstream expected(head(about));
  for (std::string wanted; std::getline(expected, wanted); compare(wanted)) std::getline(stream, line);
  std::getline(stream, line);
  if (line.starts_with(builds_line)) {
    std::istringstream builds(line.substr(builds_line.size()));
    for (std::string build; builds >> build;) note_build(build);
    std::getline(stream, line);
  }
  compare(names().substr(0, names().size() - 1));
  while (std::getline(stream, line)) {
    auto cells = cells_of(line);
    if (cells.size() != columns_.size())
      throw BadInput(
          say(words().study.damaged_table, fmt::arg("file", file.string()), fmt::arg("line", line)));
    rows_.push_back(std::move(cells));
  }
}

}  // namespace clapotis::studies
