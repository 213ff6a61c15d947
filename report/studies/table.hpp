#pragma once

#include <concepts>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/simulation/parameters.hpp"

namespace clapotis::studies {

/// A column of a study's table. The unit is "1" for a pure number and "" for a word.
struct Column {
  std::string name, unit;
};

using Row = std::vector<std::string>;

/// A number as a table holds it: it reads back as the same number; "nan" where there is none.
std::string cell(double value);
inline std::string cell(std::integral auto value) { return std::to_string(value); }
inline std::string cell(std::string_view text) { return std::string(text); }
inline std::string cell(const char* text) { return text; }
/// row("rk4", 0.1, 3): cells of any kind.
Row row(const auto&... cells) { return {cell(cells)...}; }
/// What a point gives that has a single row.
std::vector<Row> one_row(const auto&... cells) { return {row(cells...)}; }

/// A number with so many digits that count, as a reader wants it: 0.0123, 4.5e-6; "-" where there is none.
std::string rounded(double value, int digits = 3);

/// What a study has found so far. Each row is a point's key, its values, and how it came out: "done" or
/// "diverged".
class Table {
 public:
  Table(std::vector<Column> keys, std::vector<Column> values);

  void add(Row row);
  /// The rows of the point with this key.
  [[nodiscard]] std::vector<Row> of(const Row& key) const;
  /// The same columns and builds, with other rows: those of points, one after the other.
  [[nodiscard]] Table with(const std::vector<std::vector<Row>>& points) const;
  /// Notes that this build of the program has measured rows of it.
  void note_build(const std::string& fingerprint);
  [[nodiscard]] std::size_t builds() const { return builds_.size(); }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  [[nodiscard]] std::size_t width() const { return columns_.size(); }

  [[nodiscard]] const std::string& text(const Row& row, std::string_view column) const;
  [[nodiscard]] double number(const Row& row, std::string_view column) const;
  [[nodiscard]] bool diverged(const Row& row) const { return row.back() != "done"; }

  using Cells = std::initializer_list<std::pair<std::string_view, std::string_view>>;
  /// The rows that have these words in these columns, in the order of the table.
  [[nodiscard]] std::vector<Row> where(Cells cells) const;
  /// A column of some rows.
  [[nodiscard]] std::vector<double> numbers(const std::vector<Row>& rows, std::string_view column) const;
  /// The different cells of a column, in the order of the table.
  [[nodiscard]] std::vector<std::string> kinds(std::string_view column) const;

  /// CSV: `about`, the units and the builds as comments (#), the names of the columns, the rows.
  [[nodiscard]] std::string csv(const std::string& about) const;
  /// Takes the rows of a file that `csv` wrote. Throws BadInput when it is `about` something else, or has
  /// other columns.
  void read(const std::filesystem::path& file, const std::string& about);

 private:
  [[nodiscard]] std::string head(const std::string& about) const;
  [[nodiscard]] std::string names() const;
  [[nodiscard]] std::size_t place(std::string_view column) const;

  std::vector<Column> columns_;
  std::vector<Row> rows_;
  std::vector<std::string> builds_;  ///< fingerprints of the programs that measured, in their order
};

}  // namespace clapotis::studies
