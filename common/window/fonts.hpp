#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace clapotis {

/// Where the system keeps a DejaVu face (`file`, "DejaVuSans.ttf"), looked up without fontconfig in the
/// places the distributions use, below every folder of XDG_DATA_DIRS. Nothing when it is not installed: the
/// caller warns and goes on with less.
std::optional<std::filesystem::path> find_font(std::string_view file);

}  // namespace clapotis
