#include "report/studies/conclusion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace clapotis::studies {
namespace {

std::size_t letters(std::string_view text) {  // UTF-8: bytes that begin one
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(std::string text, std::size_t width) {
  text.append(width - std::min(width, letters(text)), ' ');
  return text;
}

std::string text_of(const TextTable& table) {
  std::vector<Row> lines{table.header};
  lines.insert(lines.end(), table.rows.begin(), table.rows.end());
  std::vector<std::size_t> widths(table.header.size());
  for (const auto& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) widths.at(k) = std::max(widths.at(k), letters(line[k]));
  auto text = "\n  " + table.name + '\n';
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t k = 0; k < line.size(); ++k) row += "  " + padded(line[k], widths[k]);
    text += "  " + row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

/// 1000000 is read as 1 000 000; a number with a fraction, or of four digits, as it is.
std::string grouped(std::string digits) {
  if (digits.size() < 5 || digits.find_first_not_of("0123456789") != std::string::npos) return digits;
  for (auto at = static_cast<long>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), "\\,");
  return digits;
}

/// 4.5e-06 becomes a power of ten; what TeX would take for itself is marked.
std::string latex(const std::string& text) {
  const auto e = text.find('e');
  char* end = nullptr;
  static_cast<void>(std::strtod(text.c_str(), &end));
  if (!text.empty() && *end == '\0') {
    if (e == std::string::npos) return "\\ensuremath{" + grouped(text) + '}';
    return fmt::format("\\ensuremath{{{}\\cdot 10^{{{}}}}}", text.substr(0, e),
                       std::atoi(text.c_str() + e + 1));
  }
  std::string safe;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '^' && k + 1 < text.size()) {  // m^2/s
      safe += fmt::format("\\textsuperscript{{{}}}", text[++k]);
      continue;
    }
    if (std::string_view("_%&#$").find(c) != std::string_view::npos) safe += '\\';
    safe += c;
  }
  return safe;
}

std::string row_of(const Row& cells) {
  std::string line;
  for (const auto& each : cells) line += (line.empty() ? "" : " & ") + (each.empty() ? "{}" : latex(each));
  return line + " \\\\\n";
}

}  // namespace

std::string text_of(const Conclusion& conclusion) {
  std::size_t width = 0;
  for (const auto& finding : conclusion.findings) width = std::max(width, letters(finding.meaning));
  std::string text;
  for (const auto& finding : conclusion.findings)
    text += fmt::format("  {}  {}{}{}\n", padded(finding.meaning, width), finding.value,
                        finding.unit.empty() ? "" : " ", finding.unit);
  for (const auto& table : conclusion.tables) text += text_of(table);
  return text;
}

std::string spoken(std::string_view integrator) {
  constexpr std::array names{std::pair{"explicit_euler", "explicit Euler"},
                             std::pair{"symplectic_euler", "symplectic Euler"},
                             std::pair{"velocity_verlet", "Verlet"},
                             std::pair{"rk2", "RK2"},
                             std::pair{"rk4", "RK4"},
                             std::pair{"bogacki_shampine", "Bogacki–Shampine"}};
  for (const auto& [name, words] : names)
    if (integrator == name) return words;
  return std::string(integrator);
}

std::string latex_of(const std::string& study, const Conclusion& conclusion) {
  std::string text;
  for (const auto& finding : conclusion.findings)
    text += fmt::format("\\setval{{{}/{}}}{{{}{}{}}}\n", study, finding.name, latex(finding.value),
                        finding.unit.empty() ? "" : "~", latex(finding.unit));
  for (const auto& table : conclusion.tables) {
    std::string rows;
    for (const auto& row : table.rows) rows += row_of(row);
    text += fmt::format("\\setrows{{{}/{}}}{{%\n{}}}\n", study, table.name, rows);
  }
  return text;
}

}  // namespace clapotis::studies
