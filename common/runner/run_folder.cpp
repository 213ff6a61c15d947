#include "common/runner/run_folder.hpp"

#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <system_error>

#include "common/runner/atomic_file.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

namespace fs = std::filesystem;

constexpr mode_t usual_access = 0777;

/// Whether the folder was made now; false when something of that name exists.
bool make_folder(const fs::path& folder) {
  std::error_code error;
  if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), error);
  if (error) refuse_file(words().cannot_write, folder, error.value());
  if (mkdir(folder.c_str(), usual_access) == 0) return true;
  if (errno != EEXIST) refuse_file(words().cannot_write, folder, errno);
  return false;
}

/// 0042.csv, whole or in part.
bool is_numbered(const fs::path& file, std::string_view extension) {
  const auto whole = file.extension() == ".part" ? file.stem() : file.filename();
  const auto name = whole.stem().string();
  return whole.extension() == extension &&
         std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

void remove_numbered(const fs::path& folder, std::string_view extension) {
  if (!fs::is_directory(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder))
    if (is_numbered(entry.path(), extension)) fs::remove(entry.path());
  if (fs::is_empty(folder)) fs::remove(folder);
}

/// Removes what a run writes, and nothing that somebody else put there.
void remove_run(const fs::path& folder, FilesOfFolder files) {
  for (const auto name : files) {
    fs::remove(folder / name);
    fs::remove(part_of(folder / name));
  }
  remove_numbered(folder / "frames", ".csv");
  remove_numbered(folder / "vtk", ".vtu");
}

std::string local_date() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  return fmt::format("{:04}-{:02}-{:02}-{:02}{:02}{:02}", local.tm_year + 1900, local.tm_mon + 1,
                     local.tm_mday, local.tm_hour, local.tm_min, local.tm_sec);
}

}  // namespace

RunFolder::RunFolder(fs::path folder, bool force, FilesOfFolder files) : folder_(std::move(folder)) {
  if (!folder_.has_filename()) folder_ = folder_.parent_path();  // "name/" is "name"
  if (make_folder(folder_)) return;
  const auto refuse = [&](std::string_view sentence) {
    throw FileError(say(sentence, fmt::arg("folder", folder_.string()), fmt::arg("mark", files.front())));
  };
  try {
    if (!fs::is_directory(folder_)) refuse(words().not_a_folder);
    if (fs::is_empty(folder_)) return;
    if (!force) refuse(words().folder_exists);
    if (!fs::exists(folder_ / files.front())) refuse(words().not_a_run_folder);
    remove_run(folder_, files);
  } catch (const fs::filesystem_error& error) {
    refuse_file(words().cannot_write, folder_, error.code().value());
  }
}

RunFolder RunFolder::by_date(const std::string& name) {
  const auto dated = fmt::format("runs/{}-{}", name, local_date());
  fs::path folder = dated;
  for (int number = 2; !make_folder(folder); ++number) folder = fmt::format("{}-{}", dated, number);
  return RunFolder(folder);
}

fs::path RunFolder::numbered(std::string_view folder, long number, std::string_view extension) const {
  const auto inner = folder_ / folder;
  std::error_code error;
  fs::create_directory(inner, error);
  if (error) refuse_file(words().cannot_write, inner, error.value());
  return inner / fmt::format("{:04}{}", number, extension);
}

}  // namespace clapotis
