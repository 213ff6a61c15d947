#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace clapotis {

/// The files that one kind of folder holds; the first is the mark by which it is known. Beside them,
/// frames/NNNN.csv and vtk/NNNN.vtu.
using FilesOfFolder = std::span<const std::string_view>;
inline constexpr std::array<std::string_view, 5> files_of_run{"run.json", "series.csv", "final.csv",
                                                              "picture.png", "vtk.pvd"};
inline constexpr std::array<std::string_view, 3> files_of_comparison{"compare.json", "compare.csv",
                                                                     "picture.png"};

/// The folder that a run or a comparison leaves.
class RunFolder {
 public:
  /// Makes the folder. One that exists is taken when it is empty, or, with `force`, when it holds the mark:
  /// then the files of that run are removed, and no others. Throws FileError otherwise.
  RunFolder(std::filesystem::path folder, bool force, FilesOfFolder files);

  /// A new folder runs/NAME-DATE, with a number behind it when that is taken.
  static RunFolder by_date(const std::string& name);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  [[nodiscard]] std::filesystem::path file(std::string_view name) const { return folder_ / name; }
  /// FOLDER/0042.EXTENSION; makes that folder.
  [[nodiscard]] std::filesystem::path numbered(std::string_view folder, long number,
                                               std::string_view extension) const;

 private:
  explicit RunFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
  std::filesystem::path folder_;
};

}  // namespace clapotis
