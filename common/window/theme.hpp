#pragma once

#include "common/runner/ink.hpp"

struct ImVec4;

/// The restrained look of the window: its colours are those of the palette in use.
namespace clapotis::theme {

/// Height of a line [pixel] at scale 1, ascenders to descenders: the letters are those of a 16 pixel font.
constexpr double font_size = 19;

inline constexpr ink::Tone panel{&ink::Palette::panel};  ///< behind the controls
inline constexpr ink::Tone field{&ink::Palette::field};  ///< behind what is typed, lists and notices
inline constexpr ink::Tone ink{&ink::Palette::text};
inline constexpr ink::Tone faint{&ink::Palette::faint_text};  ///< secondary text, still 5:1 against the panel
inline constexpr ink::Tone accent{&ink::Palette::accent};
inline constexpr ink::Tone caution{&ink::Palette::caution};  ///< amber, legible on the panel
inline constexpr ink::Tone warning{&ink::Palette::warning};

ImVec4 vec(Colour colour);  ///< as ImGui has it

/// While it lives, text is bold.
class Bold {
 public:
  Bold();
  ~Bold();
  Bold(const Bold&) = delete;
  Bold& operator=(const Bold&) = delete;
};

/// While it lives, buttons are those that matter most: white on the accent.
class Main {
 public:
  Main();
  ~Main();
  Main(const Main&) = delete;
  Main& operator=(const Main&) = delete;
};

/// Gives ImGui these colours, and distances that grow with `scale`.
void apply(double scale);

}  // namespace clapotis::theme
