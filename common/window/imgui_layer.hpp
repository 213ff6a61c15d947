#pragma once

#include <deque>
#include <functional>
#include <string>

#include "common/window/input.hpp"

namespace clapotis {

/// Dear ImGui's platform side: hands it our input, the size, the time and the clipboard, and paints what it
/// lays out with the OpenGL 2 renderer of its package. Knows no window library. One at a time, after an
/// OpenGL context exists.
class ImGuiLayer {
 public:
  struct Clipboard {
    std::function<std::string()> read;
    std::function<void(const std::string&)> write;
  };

  /// `scale` multiplies the font and every distance of the theme; 1 is legible on a 1280 x 720 projector.
  ImGuiLayer(double scale, Clipboard clipboard);
  ~ImGuiLayer();
  ImGuiLayer(const ImGuiLayer&) = delete;
  ImGuiLayer& operator=(const ImGuiLayer&) = delete;

  void dress(double scale);  ///< anew, when the scale or the theme has changed; between two frames
  void handle(const Input& input);
  void begin_frame(Point size, double elapsed);  ///< `elapsed` [s] since the last frame
  void paint();                                  ///< the OpenGL state must be free to change
  [[nodiscard]] bool wants_mouse() const;        ///< the mouse is over, or holds, something of the panel
  [[nodiscard]] bool wants_text() const;         ///< a text field has the keyboard

 private:
  void apply_pending();

  Clipboard clipboard_;
  std::string clipboard_text_;  ///< ImGui borrows what it reads
  std::deque<Input> pending_;   ///< used before ImGui 1.87 only, see apply_pending
};

}  // namespace clapotis
