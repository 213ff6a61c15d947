#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/window/input.hpp"

namespace clapotis {

/// The one window on the user's desk: input, a canvas over the whole of it, and ImGui on top. With
/// sfml_canvas.cpp the only place that knows SFML. Ask `display_available()` first.
class Screen {
 public:
  /// Width and height [pixel] at scale 1, at most those of the screen. `scale` multiplies everything; 0 takes
  /// one that suits the screen's height.
  Screen(const std::string& title, int width, int height, double scale);
  ~Screen();

  /// What the user did since the last call, oldest first. ImGui has been told already.
  std::vector<Input> poll();
  /// Clears the window and starts an ImGui frame. Paint on `canvas` and call ImGui before `end_frame`.
  void begin_frame(Colour background);
  /// Puts ImGui over the canvas and shows the picture; returns no sooner than 1/60 s after the last one.
  void end_frame();
  /// Lets as much time pass as a frame takes, without painting one.
  void rest();
  /// Takes over another scale, and the colours of the palette in use. Between two frames.
  void dress(double scale);
  [[nodiscard]] Canvas& canvas();
  void title(const std::string& ascii);
  [[nodiscard]] unsigned long handle() const;  ///< the operating system's name for the window
  [[nodiscard]] Point size() const;
  [[nodiscard]] double scale() const;
  [[nodiscard]] bool panel_wants_mouse() const;
  [[nodiscard]] bool panel_wants_text() const;
  /// Processor time [s] that our own thread spent between the last begin_frame and end_frame; the graphics
  /// driver's threads and the wait for the next frame are not in it.
  [[nodiscard]] double frame_cpu_seconds() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace clapotis
