#pragma once

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/common/process.hpp"

namespace clapotis::testing {

/// A CSV file as it was written.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  [[nodiscard]] double at(std::size_t row, const std::string& column) const {
    const auto place = std::find(header.begin(), header.end(), column) - header.begin();
    return std::stod(rows.at(row).at(static_cast<std::size_t>(place)));
  }
  [[nodiscard]] double last(const std::string& column) const { return at(rows.size() - 1, column); }
};

inline Table table(const std::filesystem::path& file) {
  std::istringstream lines(read(file));
  Table t;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (t.header.empty()) {
      t.header = cells;
    } else {
      t.rows.push_back(cells);
    }
  }
  return t;
}

inline nlohmann::json json(const std::filesystem::path& file) { return nlohmann::json::parse(read(file)); }

}  // namespace clapotis::testing
