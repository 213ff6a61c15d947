#include "common/window/screen.hpp"

#include <SFML/Graphics.hpp>
#include <SFML/Window/Clipboard.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "common/window/imgui_layer.hpp"
#include "common/window/sfml_canvas.hpp"

namespace clapotis {
namespace {

Key key_of(sf::Keyboard::Key code) {
  using K = sf::Keyboard;
  switch (code) {
    case K::A:
      return Key::a;
    case K::B:
      return Key::b;
    case K::C:
      return Key::c;
    case K::E:
      return Key::e;
    case K::G:
      return Key::g;
    case K::H:
      return Key::h;
    case K::L:
      return Key::l;
    case K::K:
      return Key::k;
    case K::N:
      return Key::n;
    case K::R:
      return Key::r;
    case K::V:
      return Key::v;
    case K::X:
      return Key::x;
    case K::Y:
      return Key::y;
    case K::Z:
      return Key::z;
    case K::Space:
      return Key::space;
    case K::Enter:
      return Key::enter;
    case K::Escape:
      return Key::escape;
    case K::Backspace:
      return Key::backspace;
    case K::Delete:
      return Key::del;
    case K::Tab:
      return Key::tab;
    case K::Left:
      return Key::left;
    case K::Right:
      return Key::right;
    case K::Up:
      return Key::up;
    case K::Down:
      return Key::down;
    case K::PageUp:
      return Key::page_up;
    case K::PageDown:
      return Key::page_down;
    case K::Home:
      return Key::home;
    case K::End:
      return Key::end;
    case K::LShift:
    case K::RShift:
      return Key::shift;
    case K::LControl:
    case K::RControl:
      return Key::control;
    case K::LAlt:
    case K::RAlt:
      return Key::alt;
    case K::F1:
      return Key::f1;
    case K::F2:
      return Key::f2;
    case K::F3:
      return Key::f3;
    case K::F4:
      return Key::f4;
    case K::F5:
      return Key::f5;
    case K::F9:
      return Key::f9;
    case K::F10:
      return Key::f10;
    case K::F12:
      return Key::f12;
    default:
      return Key::other;
  }
}

Point point(int x, int y) { return {static_cast<double>(x), static_cast<double>(y)}; }

Input key_input(Input::Kind kind, const sf::Event::KeyEvent& event) {
  Input input{kind};
  input.key = key_of(event.code);
  // A modifier's own press and release report the state before them.
  const bool down = kind == Input::Kind::key_down;
  input.shift = input.key == Key::shift ? down : event.shift;
  input.control = input.key == Key::control ? down : event.control;
  input.alt = input.key == Key::alt ? down : event.alt;
  return input;
}

std::optional<Input> button_input(Input::Kind kind, const sf::Event::MouseButtonEvent& event) {
  Input input{kind};
  input.at = point(event.x, event.y);
  switch (event.button) {
    case sf::Mouse::Left:
      input.button = MouseButton::left;
      return input;
    case sf::Mouse::Right:
      input.button = MouseButton::right;
      return input;
    case sf::Mouse::Middle:
      input.button = MouseButton::middle;
      return input;
    default:
      return std::nullopt;
  }
}

std::optional<Input> translate(const sf::Event& event) {
  using Kind = Input::Kind;
  switch (event.type) {
    case sf::Event::KeyPressed:
      return key_input(Kind::key_down, event.key);
    case sf::Event::KeyReleased:
      return key_input(Kind::key_up, event.key);
    case sf::Event::MouseButtonPressed:
      return button_input(Kind::button_down, event.mouseButton);
    case sf::Event::MouseButtonReleased:
      return button_input(Kind::button_up, event.mouseButton);
    case sf::Event::MouseLeft:
      return Input{Kind::left_window};
    case sf::Event::GainedFocus:
      return Input{Kind::focus_gained};
    case sf::Event::LostFocus:
      return Input{Kind::focus_lost};
    case sf::Event::Closed:
      return Input{Kind::closed};
    case sf::Event::TextEntered: {
      if (event.text.unicode < 32 || event.text.unicode == 127) return std::nullopt;  // those come as keys
      Input input{Kind::character};
      input.character = static_cast<char32_t>(event.text.unicode);
      return input;
    }
    case sf::Event::MouseMoved: {
      Input input{Kind::moved};
      input.at = point(event.mouseMove.x, event.mouseMove.y);
      return input;
    }
    case sf::Event::MouseWheelScrolled: {
      if (event.mouseWheelScroll.wheel != sf::Mouse::VerticalWheel) return std::nullopt;
      Input input{Kind::wheel};
      input.notches = static_cast<double>(event.mouseWheelScroll.delta);
      input.at = point(event.mouseWheelScroll.x, event.mouseWheelScroll.y);
      return input;
    }
    case sf::Event::Resized: {
      Input input{Kind::resized};
      input.at = {static_cast<double>(event.size.width), static_cast<double>(event.size.height)};
      return input;
    }
    default:
      return std::nullopt;
  }
}

std::string utf8(const sf::String& text) {
  const auto bytes = text.toUtf8();
  return {bytes.begin(), bytes.end()};
}

double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// 1 up to 1080 rows, then in quarters: 2 on a screen of 2160.
double scale_of_desktop() {
  return std::max(1.0, std::floor(4.0 * sf::VideoMode::getDesktopMode().height / 1080) / 4);
}

sf::VideoMode mode(int width, int height, double scale) {
  const auto desktop = sf::VideoMode::getDesktopMode();
  const auto pixels = [scale](int length, unsigned most) {
    return std::min(static_cast<unsigned>(std::lround(scale * length)), most);
  };
  return {pixels(width, desktop.width), pixels(height, desktop.height)};
}

/// The window's upper left corner that puts it in the middle of the screen; SFML 2.5 by itself takes the
/// width for the height, and hides the lower part of the window where no window manager corrects it.
sf::Vector2i centred(const sf::Vector2u& size) {
  const auto desktop = sf::VideoMode::getDesktopMode();
  return {static_cast<int>(desktop.width - std::min(size.x, desktop.width)) / 2,
          static_cast<int>(desktop.height - std::min(size.y, desktop.height)) / 2};
}

/// SFML complains of every screen without vertical sync, which we do not use. What it said is kept for a
/// failure.
class QuietStart {
 public:
  QuietStart() : before_(sf::err().rdbuf(said_.rdbuf())) {}
  ~QuietStart() { end(); }
  QuietStart(const QuietStart&) = delete;
  QuietStart& operator=(const QuietStart&) = delete;
  void end() { sf::err().rdbuf(before_); }
  [[nodiscard]] std::string said() const { return said_.str(); }

 private:
  std::ostringstream said_;
  std::streambuf* before_;
};

}  // namespace

struct Screen::Parts {
  Parts(const std::string& title, int width, int height, double wanted_scale)
      : scale(wanted_scale > 0 ? wanted_scale : scale_of_desktop()),
        window(mode(width, height, scale), title),
        canvas(window),
        imgui(scale, {[] { return utf8(sf::Clipboard::getString()); },
                      [](const std::string& text) {
                        sf::Clipboard::setString(sf::String::fromUtf8(text.begin(), text.end()));
                      }}) {
    if (!window.isOpen()) throw std::runtime_error("no window: " + start.said());
    start.end();
    window.setPosition(centred(window.getSize()));
    window.setFramerateLimit(60);  // not vertical sync: some drivers stop a minimised window for good
  }
  double scale;
  QuietStart start;
  sf::RenderWindow window;
  SfmlCanvas canvas;
  ImGuiLayer imgui;
  sf::Clock clock;
  std::array<bool, static_cast<std::size_t>(Key::f12) + 1> held{};
  double cpu_at_start = 0, frame_cpu = 0;
};

Screen::Screen(const std::string& title, int width, int height, double scale)
    : parts_(std::make_unique<Parts>(title, width, height, scale)) {}

Screen::~Screen() = default;

std::vector<Input> Screen::poll() {
  std::vector<Input> inputs;
  for (sf::Event event{}; parts_->window.pollEvent(event);) {
    if (auto input = translate(event)) {
      const auto held = static_cast<std::size_t>(input->key);
      if (input->kind == Input::Kind::key_down) input->repeat = std::exchange(parts_->held[held], true);
      if (input->kind == Input::Kind::key_up) parts_->held[held] = false;
      if (input->kind == Input::Kind::focus_lost) parts_->held.fill(false);
      parts_->imgui.handle(*input);
      inputs.push_back(*input);
    }
  }
  return inputs;
}

void Screen::begin_frame(Colour background) {
  parts_->cpu_at_start = thread_cpu_seconds();
  parts_->canvas.start(background);
  parts_->imgui.begin_frame(size(), static_cast<double>(parts_->clock.restart().asSeconds()));
}

void Screen::end_frame() {
  parts_->canvas.flush();
  parts_->window.pushGLStates();
  parts_->imgui.paint();
  parts_->window.popGLStates();
  parts_->frame_cpu = thread_cpu_seconds() - parts_->cpu_at_start;
  parts_->window.display();
}

void Screen::rest() { sf::sleep(sf::seconds(1 / 60.0F)); }

void Screen::dress(double scale) {
  parts_->scale = scale;
  parts_->imgui.dress(scale);
}

Canvas& Screen::canvas() { return parts_->canvas; }
void Screen::title(const std::string& ascii) { parts_->window.setTitle(ascii); }

unsigned long Screen::handle() const { return static_cast<unsigned long>(parts_->window.getSystemHandle()); }

Point Screen::size() const {
  const auto size = parts_->window.getSize();
  return {static_cast<double>(size.x), static_cast<double>(size.y)};
}

double Screen::scale() const { return parts_->scale; }
bool Screen::panel_wants_mouse() const { return parts_->imgui.wants_mouse(); }
bool Screen::panel_wants_text() const { return parts_->imgui.wants_text(); }
double Screen::frame_cpu_seconds() const { return parts_->frame_cpu; }

}  // namespace clapotis
