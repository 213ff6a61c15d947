#pragma once

#include <string>
#include <vector>

#include "common/runner/canvas.hpp"

namespace clapotis {

/// Remembers what it is asked to paint. A letter is 0.6 of its text's height wide.
class RecordingCanvas final : public Canvas {
 public:
  struct Text {
    Point at;  ///< left end of the baseline
    std::string words;
    double height, width;
  };

  explicit RecordingCanvas(Point size = {1280, 720}) : size_(size) {}

  std::vector<std::vector<Disc>> disc_calls;
  std::vector<std::vector<Point>> lines;
  std::vector<Text> texts;

  [[nodiscard]] Point size() const override { return size_; }
  void rectangle(const Box& /*box*/, Colour /*fill*/) override {}
  void discs(std::span<const Disc> discs) override { disc_calls.emplace_back(discs.begin(), discs.end()); }
  void line(std::span<const Point> points, Colour /*colour*/, double /*width*/) override {
    lines.emplace_back(points.begin(), points.end());
  }
  void text(Point at, std::string_view utf8, double height, Colour /*colour*/, Align align) override {
    const double width = text_width(utf8, height);
    const double before = align == Align::left ? 0 : align == Align::centre ? width / 2 : width;
    texts.push_back({{at.x - before, at.y}, std::string(utf8), height, width});
  }
  [[nodiscard]] double text_width(std::string_view utf8, double height) const override {
    double letters = 0;
    for (const char byte : utf8) letters += (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U ? 0 : 1;
    return 0.6 * height * letters;
  }
  void clip(const Box& /*box*/) override {}
  void unclip() override {}

 private:
  Point size_;
};

}  // namespace clapotis
