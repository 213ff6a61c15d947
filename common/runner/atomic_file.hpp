#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace clapotis {

/// What becomes of a file that could not be finished.
enum class Unfinished { remove, keep };

/// A file that appears under its name only when it is whole: it grows as `name.part` in the same folder and
/// is renamed by `commit`. A killed program leaves the part, never half a file under the final name; without
/// `commit` the part is removed or kept. Every function throws FileError with the file's name and the
/// system's reason.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path, Unfinished unfinished = Unfinished::remove);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view text);
  /// Hands what was written so far to the system, so that it outlives this program.
  void flush();
  void commit();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  [[noreturn]] void fail();

  std::filesystem::path path_, part_;
  std::string buffer_;
  int file_ = -1;
  Unfinished unfinished_;
};

/// The name under which a file grows.
std::filesystem::path part_of(const std::filesystem::path& path);

/// Writes a whole file at once.
void write_file(const std::filesystem::path& path, std::string_view text);

/// Throws FileError where no file of that name can be made: its folder is not there, or it is a folder
/// itself. Asked before a long run, not after it.
void check_place(const std::filesystem::path& file);

/// Throws FileError with the file's name and the reason for `error_number` (errno).
[[noreturn]] void refuse_file(std::string_view sentence, const std::filesystem::path& path, int error_number);

}  // namespace clapotis
