#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/runner/comparison.hpp"

namespace clapotis {

/// One row of compare.csv, as the comparison stands: NaN where a side can no longer be compared.
std::string compare_row(const Comparison& comparison, const Side& left, const Side& right);
std::string compare_header();

/// compare.json: both sides, their difference, the ratio of their cost; `warnings` are whole sentences.
std::string compare_manifest(const Comparison& comparison, const Side& left, const Side& right,
                             std::string_view stop_reason, const std::vector<std::string>& warnings);

/// The same on some lines, for the terminal.
std::string compare_summary(const std::filesystem::path& folder, const Comparison& comparison,
                            const Side& left, const Side& right, const std::vector<std::string>& warnings);

/// Sentences about what limits the comparison.
std::vector<std::string> compare_warnings(const Comparison& comparison, const Side& left, const Side& right);

}  // namespace clapotis
