#include "common/window/fonts.hpp"

#include <cstdlib>
#include <sstream>
#include <string>

namespace clapotis {

std::optional<std::filesystem::path> find_font(std::string_view file) {
  const char* listed = std::getenv("XDG_DATA_DIRS");
  std::istringstream folders(listed && *listed ? listed : "/usr/local/share:/usr/share");
  for (std::string folder; std::getline(folders, folder, ':');) {
    // Debian and Ubuntu; Arch; Fedora; Alpine and openSUSE.
    for (const char* below : {"truetype/dejavu", "TTF", "dejavu-sans-fonts", "dejavu", "truetype"}) {
      const auto path = std::filesystem::path(folder) / "fonts" / below / file;
      std::error_code unreadable;
      if (std::filesystem::is_regular_file(path, unreadable)) return path;
    }
  }
  return std::nullopt;
}

}  // namespace clapotis
