#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "common/runner/canvas.hpp"

// cairo_t and cairo_surface_t, so that cairo's header stays out of ours. The names are cairo's.
struct _cairo;          // NOLINT(bugprone-reserved-identifier)
struct _cairo_surface;  // NOLINT(bugprone-reserved-identifier)

namespace clapotis {

enum class PictureFormat { png, svg, pdf };

/// By the file's extension, upper or lower case. Throws std::invalid_argument, naming the three, for any
/// other one: a command line asks before a long run, not after it.
[[nodiscard]] PictureFormat picture_format(const std::filesystem::path& file);

/// A canvas in memory that needs no display and becomes a PNG, SVG or PDF file when it is saved.
class CairoCanvas final : public Canvas {
 public:
  /// `size` in pixels (PNG; rounded up) or points (SVG, PDF), from 1 to 32767. Throws std::invalid_argument
  /// for an unknown extension or another size.
  CairoCanvas(std::filesystem::path file, Point size);
  /// An image that becomes no file: its pixels are what is wanted.
  explicit CairoCanvas(Point size);
  ~CairoCanvas() override;
  CairoCanvas(const CairoCanvas&) = delete;
  CairoCanvas& operator=(const CairoCanvas&) = delete;

  /// Writes to a temporary name in the same folder, then renames: the file is whole or it is not there. Once
  /// only; nothing can be painted afterwards. Throws std::system_error that names the file and the reason.
  void save();
  /// Of a PNG or an image, rows of 4 bytes per pixel: blue, green, red, nothing.
  [[nodiscard]] std::span<const unsigned char> pixels();

  [[nodiscard]] Point size() const override { return size_; }
  void rectangle(const Box& box, Colour fill) override;
  void discs(std::span<const Disc> discs) override;
  void line(std::span<const Point> points, Colour colour, double width) override;
  void segments(std::span<const Point> ends, Colour colour, double width) override;
  void text(Point at, std::string_view utf8, double height, Colour colour,
            Align align = Align::left) override;
  [[nodiscard]] double text_width(std::string_view utf8, double height) const override;
  void clip(const Box& box) override;
  void unclip() override;

 private:
  std::filesystem::path file_;
  PictureFormat format_;
  Point size_;
  std::string bytes_;  ///< what cairo has encoded so far; outlives surface_, which writes to it
  std::unique_ptr<_cairo_surface, void (*)(_cairo_surface*)> surface_;
  std::unique_ptr<_cairo, void (*)(_cairo*)> cairo_;
};

}  // namespace clapotis
