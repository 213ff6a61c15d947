#include "common/window/imgui_layer.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "backends/imgui_impl_opengl2.h"
#include "common/runner/exit_code.hpp"
#include "common/window/fonts.hpp"
#include "common/window/theme.hpp"
#include "common/words.hpp"
#include "imgui.h"

namespace clapotis {
namespace {

constexpr std::array<std::pair<Key, ImGuiKey>, 19> keys{{{Key::tab, ImGuiKey_Tab},
                                                         {Key::left, ImGuiKey_LeftArrow},
                                                         {Key::right, ImGuiKey_RightArrow},
                                                         {Key::up, ImGuiKey_UpArrow},
                                                         {Key::down, ImGuiKey_DownArrow},
                                                         {Key::page_up, ImGuiKey_PageUp},
                                                         {Key::page_down, ImGuiKey_PageDown},
                                                         {Key::home, ImGuiKey_Home},
                                                         {Key::end, ImGuiKey_End},
                                                         {Key::del, ImGuiKey_Delete},
                                                         {Key::backspace, ImGuiKey_Backspace},
                                                         {Key::enter, ImGuiKey_Enter},
                                                         {Key::escape, ImGuiKey_Escape},
                                                         {Key::a, ImGuiKey_A},
                                                         {Key::c, ImGuiKey_C},
                                                         {Key::v, ImGuiKey_V},
                                                         {Key::x, ImGuiKey_X},
                                                         {Key::y, ImGuiKey_Y},
                                                         {Key::z, ImGuiKey_Z}}};

bool is_key(const Input& input) {
  return input.kind == Input::Kind::key_down || input.kind == Input::Kind::key_up;
}
bool is_button(const Input& input) {
  return input.kind == Input::Kind::button_down || input.kind == Input::Kind::button_up;
}

#if IMGUI_VERSION_NUM >= 18700
#if IMGUI_VERSION_NUM >= 18900
constexpr auto shift_key = ImGuiMod_Shift, control_key = ImGuiMod_Ctrl, alt_key = ImGuiMod_Alt;
#else
constexpr auto shift_key = ImGuiKey_ModShift, control_key = ImGuiKey_ModCtrl, alt_key = ImGuiKey_ModAlt;
#endif

/// ImGui keeps its own queue: hand everything over at once.
void feed(const Input& input) {
  auto& io = ImGui::GetIO();
  using Kind = Input::Kind;
  if (is_key(input)) {
    io.AddKeyEvent(shift_key, input.shift);
    io.AddKeyEvent(control_key, input.control);
    io.AddKeyEvent(alt_key, input.alt);
    for (const auto& [ours, theirs] : keys) {
      if (ours == input.key) io.AddKeyEvent(theirs, input.kind == Kind::key_down);
    }
  } else if (is_button(input)) {
    io.AddMousePosEvent(static_cast<float>(input.at.x), static_cast<float>(input.at.y));
    io.AddMouseButtonEvent(static_cast<int>(input.button), input.kind == Kind::button_down);
  } else if (input.kind == Kind::moved) {
    io.AddMousePosEvent(static_cast<float>(input.at.x), static_cast<float>(input.at.y));
  } else if (input.kind == Kind::left_window) {
    io.AddMousePosEvent(-FLT_MAX, -FLT_MAX);
  } else if (input.kind == Kind::wheel) {
    io.AddMouseWheelEvent(0, static_cast<float>(input.notches));
  } else if (input.kind == Kind::character) {
    io.AddInputCharacter(static_cast<unsigned>(input.character));
  } else if (input.kind == Kind::focus_gained || input.kind == Kind::focus_lost) {
    io.AddFocusEvent(input.kind == Kind::focus_gained);
  }
}
#else
void feed(const Input& input) {
  auto& io = ImGui::GetIO();
  using Kind = Input::Kind;
  if (is_key(input)) {
    io.KeyShift = input.shift;
    io.KeyCtrl = input.control;
    io.KeyAlt = input.alt;
    io.KeysDown[static_cast<int>(input.key)] = input.key != Key::other && input.kind == Kind::key_down;
  } else if (is_button(input)) {
    io.MousePos = {static_cast<float>(input.at.x), static_cast<float>(input.at.y)};
    io.MouseDown[static_cast<int>(input.button)] = input.kind == Kind::button_down;
  } else if (input.kind == Kind::moved) {
    io.MousePos = {static_cast<float>(input.at.x), static_cast<float>(input.at.y)};
  } else if (input.kind == Kind::left_window) {
    io.MousePos = {-FLT_MAX, -FLT_MAX};
  } else if (input.kind == Kind::wheel) {
    io.MouseWheel += static_cast<float>(input.notches);
  } else if (input.kind == Kind::character) {
    io.AddInputCharacter(static_cast<unsigned>(input.character));
  } else if (input.kind == Kind::focus_lost) {
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
    io.KeyShift = io.KeyCtrl = io.KeyAlt = false;
  }
}
#endif

/// Latin, Greek, and the punctuation, arrows, superscripts and operators of formulas.
constexpr std::array<ImWchar, 19> glyphs{0x20,   0x17F,  0x370,  0x3FF,  0x1D62, 0x1D6A, 0x2000,
                                         0x2027, 0x2032, 0x2033, 0x2070, 0x209F, 0x2190, 0x22FF,
                                         0x25A0, 0x25FF, 0x2713, 0x2717, 0};

void load_fonts(double scale) {
  auto& fonts = *ImGui::GetIO().Fonts;
  const auto size = static_cast<float>(theme::font_size * scale);
  for (const char* face : {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"}) {
    if (const auto path = find_font(face)) {
      fonts.AddFontFromFileTTF(path->string().c_str(), size, nullptr, glyphs.data());
    }
  }
  if (fonts.Fonts.empty()) {
    complain("clapotis", words().no_greek_letters);
    ImFontConfig plain;
    plain.SizePixels = size;
    fonts.AddFontDefault(&plain);
  }
}

}  // namespace

ImGuiLayer::ImGuiLayer(double scale, Clipboard clipboard) : clipboard_(std::move(clipboard)) {
  ImGui::CreateContext();
  auto& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // a lecture starts from the same layout every time
  io.LogFilename = nullptr;
  io.BackendPlatformName = "clapotis";
#if IMGUI_VERSION_NUM < 18700
  for (const auto& [ours, theirs] : keys) io.KeyMap[theirs] = static_cast<int>(ours);
#endif
#if IMGUI_VERSION_NUM >= 19110
  auto& platform = ImGui::GetPlatformIO();
  platform.Platform_ClipboardUserData = this;
  platform.Platform_GetClipboardTextFn = [](ImGuiContext*) {
    auto& self = *static_cast<ImGuiLayer*>(ImGui::GetPlatformIO().Platform_ClipboardUserData);
    return (self.clipboard_text_ = self.clipboard_.read()).c_str();
  };
  platform.Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) {
    static_cast<ImGuiLayer*>(ImGui::GetPlatformIO().Platform_ClipboardUserData)->clipboard_.write(text);
  };
#else
  io.ClipboardUserData = this;
  io.GetClipboardTextFn = [](void* user) {
    auto& self = *static_cast<ImGuiLayer*>(user);
    return (self.clipboard_text_ = self.clipboard_.read()).c_str();
  };
  io.SetClipboardTextFn = [](void* user, const char* text) {
    static_cast<ImGuiLayer*>(user)->clipboard_.write(text);
  };
#endif
  load_fonts(scale);
  theme::apply(scale);
  ImGui_ImplOpenGL2_Init();
}

void ImGuiLayer::dress(double scale) {
#if IMGUI_VERSION_NUM < 19200  // from then on the backend notices by itself
  ImGui_ImplOpenGL2_DestroyFontsTexture();
#endif
  ImGui::GetIO().Fonts->Clear();
  load_fonts(scale);
#if IMGUI_VERSION_NUM < 19200
  ImGui_ImplOpenGL2_CreateFontsTexture();
#endif
  theme::apply(scale);
}

ImGuiLayer::~ImGuiLayer() {
  ImGui_ImplOpenGL2_Shutdown();
  ImGui::DestroyContext();
}

void ImGuiLayer::handle(const Input& input) {
#if IMGUI_VERSION_NUM >= 18700
  feed(input);
#else
  pending_.push_back(input);
#endif
}

/// Before 1.87 ImGui sees only the state at the start of a frame: a click whose press and release fall
/// between two frames would be lost, and so would the last move of a drag. So one frame is given either mouse
/// moves, or characters, or one single change of a key, a button or the wheel; what follows waits for the
/// next frame.
void ImGuiLayer::apply_pending() {
  const auto kind_of_change = [](const Input& input) {
    if (input.kind == Input::Kind::moved) return 1;
    if (input.kind == Input::Kind::character) return 2;
    const bool single =
        is_button(input) || input.kind == Input::Kind::wheel || (is_key(input) && input.key != Key::other);
    return single ? 3 : 0;
  };
  int changed = 0;
  while (!pending_.empty()) {
    const int next = kind_of_change(pending_.front());
    if (next != 0 && changed != 0 && (next != changed || next == 3)) return;
    changed = std::max(changed, next);
    feed(pending_.front());
    pending_.pop_front();
  }
}

void ImGuiLayer::begin_frame(Point size, double elapsed) {
  auto& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(std::max(size.x, 1.0)), static_cast<float>(std::max(size.y, 1.0))};
  io.DeltaTime = static_cast<float>(std::clamp(elapsed, 1e-4, 0.25));
  apply_pending();
  ImGui_ImplOpenGL2_NewFrame();
  ImGui::NewFrame();
}

void ImGuiLayer::paint() {
  ImGui::Render();
  ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
}

bool ImGuiLayer::wants_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
bool ImGuiLayer::wants_text() const { return ImGui::GetIO().WantTextInput; }

}  // namespace clapotis
