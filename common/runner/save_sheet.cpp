#include "common/runner/save_sheet.hpp"

#include <system_error>

#include "common/runner/atomic_file.hpp"
#include "common/runner/sheet.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

template <class... Pictures>
void save(const std::filesystem::path& file, std::span<const Plot> plots, const Pictures&... pictures) {
  try {
    write_sheet(file, pictures..., plots);
  } catch (const std::system_error& error) {
    refuse_file(words().cannot_write, file, error.code().value());
  }
}

}  // namespace

void save_sheet(const std::filesystem::path& file, const Picture& picture, std::span<const Plot> plots) {
  save(file, plots, picture);
}

void save_sheet(const std::filesystem::path& file, const Picture& left, const Beside& beside,
                std::span<const Plot> plots) {
  save(file, plots, left, beside);
}

}  // namespace clapotis
