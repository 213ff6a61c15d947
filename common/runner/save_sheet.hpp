#pragma once

#include <filesystem>
#include <span>

#include "common/runner/sheet.hpp"

namespace clapotis {

/// write_sheet, whose failures become FileError.
void save_sheet(const std::filesystem::path& file, const Picture& picture, std::span<const Plot> plots);
void save_sheet(const std::filesystem::path& file, const Picture& left, const Beside& beside,
                std::span<const Plot> plots);

}  // namespace clapotis
