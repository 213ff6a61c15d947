#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace clapotis {

/// The bytes of a state do not hold what is asked of them: they are of something else.
struct ForeignState : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a state consists of, as bytes. One list of values serves both ways, `state(x, y, column)`: it writes
/// them one behind the other, or reads the same ones back into their places, so that no value can be written
/// and forgotten on the way back. Numbers keep their bits; bytes are those of this machine.
class StateBytes {
 public:
  /// Writes; `bytes` has the result.
  StateBytes() = default;
  /// Reads from what another one wrote.
  explicit StateBytes(std::string bytes) : bytes_(std::move(bytes)), reads_(true) {}
  /// Writes over what is in `used`, whose memory serves again.
  [[nodiscard]] static StateBytes over(std::string used) {
    StateBytes state;
    state.bytes_ = std::move(used);
    state.bytes_.clear();
    return state;
  }

  [[nodiscard]] bool reads() const { return reads_; }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] std::string take() && { return std::move(bytes_); }

  /// Writes or reads each of them, in this order: numbers, words, Eigen's arrays, lists of such. Throws
  /// ForeignState when there are too few bytes.
  template <class... Values>
  void operator()(Values&... values) {
    (pass(values), ...);
  }
  /// Throws ForeignState when bytes are left.
  void end() const {
    if (reads_ && at_ != bytes_.size()) throw ForeignState("bytes are left over");
  }

 private:
  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void pass(Number& number) { raw(&number, sizeof number); }
  template <class Array>
  void pass(Eigen::PlainObjectBase<Array>& array) {
    using Scalar = typename Array::Scalar;
    const auto rows = pass_count(array.rows()), columns = pass_count(array.cols());
    if (reads_) {
      const bool fits = Array::ColsAtCompileTime == Eigen::Dynamic || columns == array.cols();
      const auto left = static_cast<std::int64_t>((bytes_.size() - at_) / sizeof(Scalar));
      if (!fits || (rows > 0 && columns > left / rows)) throw ForeignState("an array of another shape");
      array.resize(rows, columns);
    }
    raw(array.data(), static_cast<std::size_t>(array.size()) * sizeof(Scalar));
  }
  void pass(std::string& text) {
    const auto length = static_cast<std::size_t>(pass_count(std::ssize(text)));
    if (reads_) text.resize(length);
    raw(text.data(), length);
  }
  template <class T>
  void pass(std::vector<T>& list) {
    const auto length = static_cast<std::size_t>(pass_count(std::ssize(list)));
    if (reads_) list.resize(length);
    for (auto& value : list) pass(value);
  }

  /// A count that more bytes follow than it says: what is asked for is never more than what is there.
  std::int64_t pass_count(std::int64_t count) {
    raw(&count, sizeof count);
    if (reads_ && (count < 0 || static_cast<std::uint64_t>(count) > bytes_.size()))
      throw ForeignState("a length is out of all proportion");
    return count;
  }
  void raw(void* data, std::size_t size) {
    if (!reads_) {
      bytes_.append(static_cast<const char*>(data), size);
      return;
    }
    if (size > bytes_.size() - at_) throw ForeignState("bytes are missing");
    if (size > 0) std::memcpy(data, bytes_.data() + at_, size);
    at_ += size;
  }

  std::string bytes_;
  std::size_t at_ = 0;
  bool reads_ = false;
};

}  // namespace clapotis
