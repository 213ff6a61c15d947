#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "report/studies/table.hpp"

namespace clapotis::studies {

/// How much work a study takes on: `quick` is for a first look, with fewer, coarser and shorter runs.
enum class Effort { full, quick };

/// One thing that a study tries.
struct Point {
  Row key;  ///< its cells in the key columns; no two points of a study have the same
  /// Its cells in the other columns: one row, or several for a curve. May throw Diverged: that is a result
  /// too.
  std::function<std::vector<Row>()> measure;
  double weight = 1;  ///< how much longer than others it is expected to take, for the time that is left
};

/// A number that a study comes to, for its summary and for the text of the report.
struct Finding {
  std::string name;     ///< for the report: \val{STUDY/NAME}
  std::string value;    ///< as it is to be read, rounded: see `rounded`
  std::string unit;     ///< "" for a pure number or a word
  std::string meaning;  ///< what it is, in a few words
};

/// A table for the summary and the report: \rows{STUDY/NAME}.
struct TextTable {
  std::string name;
  Row header;
  std::vector<Row> rows;
};

struct Conclusion {
  std::vector<Finding> findings;
  std::vector<TextTable> tables = {};
};

/// A question that a sweep of runs answers: one file, one CSV, one figure.
struct Study {
  std::string name;
  std::string question;
  std::vector<Column> keys, values;  ///< what is varied, and what is found
  std::function<std::vector<Point>(Effort)> points;
  /// Reads the table, which may be of a quick study, and have points that diverged.
  std::function<Conclusion(const Table&)> conclude;
};

}  // namespace clapotis::studies
