#include "common/runner/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr std::size_t enough_to_write = 1 << 16;
constexpr mode_t readable_by_all = 0666;

}  // namespace

std::filesystem::path part_of(const std::filesystem::path& path) {
  auto part = path;
  part += ".part";
  return part;
}

void check_place(const std::filesystem::path& file) {
  const auto folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(folder)) refuse_file(words().cannot_write, file, ENOENT);
  if (std::filesystem::is_directory(file)) refuse_file(words().cannot_write, file, EISDIR);
}

void refuse_file(std::string_view sentence, const std::filesystem::path& path, int error_number) {
  throw FileError(say(sentence, fmt::arg("file", path.string()),
                      fmt::arg("reason", called(std::generic_category().message(error_number)))));
}

AtomicFile::AtomicFile(std::filesystem::path path, Unfinished unfinished)
    : path_(std::move(path)), part_(part_of(path_)), unfinished_(unfinished) {
  file_ = open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable_by_all);
  if (file_ < 0) fail();
}

AtomicFile::~AtomicFile() {
  if (file_ < 0) return;
  close(file_);
  if (unfinished_ == Unfinished::remove) unlink(part_.c_str());
}

void AtomicFile::fail() { refuse_file(words().cannot_write, path_, errno); }

void AtomicFile::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= enough_to_write) flush();
}

void AtomicFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const auto written = ::write(file_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void AtomicFile::commit() {
  flush();
  const int file = file_;
  file_ = -1;
  if (close(file) != 0 || std::rename(part_.c_str(), path_.c_str()) != 0) {
    const int reason = errno;
    unlink(part_.c_str());
    errno = reason;
    fail();
  }
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace clapotis
