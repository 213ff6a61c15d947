#include "tests/window/desk.hpp"

#include <cairo/cairo.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace clapotis::testing {
namespace {

using Clock = std::chrono::steady_clock;

Clock::time_point in(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

int milliseconds_until(Clock::time_point end) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
  return static_cast<int>(std::max<decltype(left)>(left, 0));
}

int exit_code(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

/// The two ends of a pipe that only the child that asks for one inherits.
std::array<int, 2> pipe_ends() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe to be had");
  return ends;
}

std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t got = 0; (got = read(descriptor, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
  return text;
}

}  // namespace

Child::Child(const std::vector<std::string>& command, const std::map<std::string, std::string>& environment,
             const std::filesystem::path& log, const std::vector<int>& keep) {
  std::vector<char*> words;
  for (const auto& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t parent = getpid();
  id_ = fork();
  if (id_ < 0) throw std::runtime_error("cannot start " + command.front());
  if (id_ > 0) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // the test died before the line above
  const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  if (keep.empty() || std::find(keep.begin(), keep.end(), 1) == keep.end()) dup2(out, 1);
  dup2(out, 2);
  for (const int descriptor : keep) fcntl(descriptor, F_SETFD, 0);
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  if (chdir(log.parent_path().c_str()) != 0) _exit(127);
  execvp(words.front(), words.data());
  _exit(127);
}

/// Asked first: a killed X server would leave its lock and its socket behind.
Child::~Child() {
  if (ended_) return;
  kill(id_, SIGTERM);
  if (!ends_within(5)) kill(id_, SIGKILL);
  waitpid(id_, nullptr, 0);
}

bool Child::ends_within(double seconds) const {
  const int process = static_cast<int>(syscall(SYS_pidfd_open, id_, 0));
  if (process < 0) return false;
  pollfd ended{process, POLLIN, 0};
  const bool in_time = poll(&ended, 1, static_cast<int>(1000 * seconds)) > 0;
  close(process);
  return in_time;
}

int Child::await_end(double seconds) {
  if (!ends_within(seconds)) throw std::runtime_error("the program did not end in time");
  int status = 0;
  waitpid(id_, &status, 0);
  ended_ = true;
  return exit_code(status);
}

Desk::Desk(const std::string& name, WindowManager manager)
    : folder_(std::filesystem::path(WINDOW_ARTEFACTS) / name) {
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directories(folder_);
  server_folder_ = folder_ / "framebuffer";
  std::filesystem::create_directories(server_folder_);
  const auto number = pipe_ends();
  server_ = std::make_unique<Child>(
      std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(number[1]), "-screen", "0", "1280x800x24",
                               "-fbdir", server_folder_.string(), "-nolisten", "tcp", "-noreset"},
      environment_, folder_ / "server.log", std::vector<int>{number[1]});
  close(number[1]);
  pollfd ready{number[0], POLLIN, 0};
  std::string display;
  std::array<char, 16> buffer{};
  while (display.find('\n') == std::string::npos && poll(&ready, 1, 60000) > 0) {
    const auto got = read(number[0], buffer.data(), buffer.size());
    if (got <= 0) break;
    display.append(buffer.data(), static_cast<std::size_t>(got));
  }
  close(number[0]);
  if (display.empty())
    throw std::runtime_error("Xvfb did not start, see " + (folder_ / "server.log").string());
  environment_["DISPLAY"] = ":" + display.substr(0, display.find('\n'));
  environment_["LIBGL_ALWAYS_SOFTWARE"] = "1";
  environment_["LC_ALL"] = "C.UTF-8";               // whatever this machine speaks
  environment_["ASAN_OPTIONS"] = "detect_leaks=0";  // the graphics driver's, in a build with sanitizers
  if (manager == WindowManager::openbox) start_openbox();
}

/// Returns once openbox manages windows: one that is mapped while it starts may never be shown.
void Desk::start_openbox() {
  const auto path = folder_ / "openbox.started";
  if (mkfifo(path.c_str(), 0600) != 0) throw std::runtime_error("no pipe at " + path.string());
  const int started = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  manager_ = std::make_unique<Child>(std::vector<std::string>{"openbox", "--sm-disable", "--startup",
                                                              "sh -c 'echo > \"" + path.string() + "\"'"},
                                     environment_, folder_ / "openbox.log");
  pollfd ready{started, POLLIN, 0};
  const bool in_time = poll(&ready, 1, 60000) > 0;
  close(started);
  std::filesystem::remove(path);
  if (!in_time) throw std::runtime_error("openbox did not start");
}

Desk::~Desk() {
  program_.reset();
  if (trace_ >= 0) close(trace_);
  manager_.reset();
  server_.reset();
  std::error_code ignored;
  std::filesystem::remove_all(server_folder_, ignored);
  std::ofstream log(folder_ / "trace.log");
  for (const auto& line : lines_) log << line.text << '\n';
}

void Desk::start(const std::vector<std::string>& command, const std::map<std::string, std::string>& more) {
  const auto ends = pipe_ends();
  auto environment = environment_;
  for (const auto& [name, value] : more) environment[name] = value;
  environment["CLAPOTIS_TRACE"] = "/dev/fd/" + std::to_string(ends[1]);
  program_ =
      std::make_unique<Child>(command, environment, folder_ / "program.log", std::vector<int>{ends[1]});
  close(ends[1]);
  trace_ = ends[0];
  trace_open_ = true;
  fcntl(trace_, F_SETFL, O_NONBLOCK);
  window_ = await("window open ");
  if (!manager_) xdotool({"windowmove", window_, "0", "0"});
  move(640, 700);
}

bool Desk::read_lines(double seconds) {
  if (!trace_open_) return false;
  pollfd ready{trace_, POLLIN, 0};
  if (poll(&ready, 1, static_cast<int>(1000 * seconds)) <= 0) return true;
  std::array<char, 4096> buffer{};
  const auto got = read(trace_, buffer.data(), buffer.size());
  if (got == 0) return trace_open_ = false;
  if (got < 0) return true;
  rest_.append(buffer.data(), static_cast<std::size_t>(got));
  for (std::size_t end = 0; (end = rest_.find('\n')) != std::string::npos;) {
    std::string line = rest_.substr(0, end);
    rest_.erase(0, end + 1);
    if (line.empty()) {
      ++frames_ended_;
    } else if (line.starts_with("control ")) {
      std::istringstream words(line.substr(8));
      std::string name;
      Place place;
      words >> name >> place.x >> place.y >> place.width >> place.height;
      controls_[name] = place;
    } else {
      lines_.push_back({std::move(line), frames_ended_});
    }
  }
  return true;
}

std::string Desk::await(std::string_view beginning, double seconds) {
  const auto end = in(seconds);
  for (;;) {
    if (const auto line = find(beginning); line != lines_.end()) {
      line->returned = true;
      frame_ = line->frame;
      return line->text.substr(beginning.size());
    }
    const int left = milliseconds_until(end);
    if (left == 0) fail("waited in vain for \"" + std::string(beginning) + "\"");
    if (!read_lines(left / 1000.0)) fail("the program ended before \"" + std::string(beginning) + "\"");
  }
}

std::vector<Desk::Line>::iterator Desk::find(std::string_view beginning) {
  return std::find_if(lines_.begin(), lines_.end(), [&](const Line& line) {
    return line.frame >= frame_ && !line.returned && line.text.starts_with(beginning);
  });
}

bool Desk::seen(std::string_view beginning) {
  read_lines(0);
  return find(beginning) != lines_.end();
}

int Desk::await_exit(double seconds) {
  const auto end = in(seconds);
  while (read_lines(milliseconds_until(end) / 1000.0)) {
    if (milliseconds_until(end) == 0) fail("the program goes on");
  }
  return program_->await_end(milliseconds_until(end) / 1000.0);
}

void Desk::interrupt() { kill(program_->id(), SIGINT); }

void Desk::fail(const std::string& sentence) const {
  std::ostringstream text;
  text << sentence << "\nwhat came until then:";
  for (const auto& line : lines_) text << "\n  " << (line.returned ? "* " : "  ") << line.text;
  std::ifstream log(folder_ / "program.log");
  text << "\nprinted:\n" << std::string(std::istreambuf_iterator<char>(log), {});
  throw std::runtime_error(text.str());
}

std::string Desk::xdotool_output(const std::vector<std::string>& words) {
  std::vector<std::string> command{"sh", "-c", "exec \"$@\" >&$OUT", "sh", "xdotool"};
  command.insert(command.end(), words.begin(), words.end());
  const auto ends = pipe_ends();
  auto environment = environment_;
  environment["OUT"] = std::to_string(ends[1]);
  Child tool(command, environment, folder_ / "xdotool.log", {ends[1]});
  close(ends[1]);
  std::string text = read_all(ends[0]);
  close(ends[0]);
  if (tool.await_end(30) != 0) fail("xdotool " + words.front() + " failed");
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

void Desk::xdotool(const std::vector<std::string>& words) { xdotool_output(words); }

void Desk::move(int x, int y) {
  xdotool({"mousemove", "--window", window_, std::to_string(x), std::to_string(y)});
}

void Desk::click(int x, int y, int button) {
  xdotool({"mousemove", "--window", window_, std::to_string(x), std::to_string(y), "click",
           std::to_string(button)});
}

Pixel Desk::pixel_of(double x, double y, double scene_width, double scene_height) {
  const Place box = control("domain");
  return {box.x + static_cast<int>(x / scene_width * box.width),
          box.y + static_cast<int>((1 - y / scene_height) * box.height)};
}

void Desk::press(int x, int y, int button) {
  xdotool({"mousemove", "--window", window_, std::to_string(x), std::to_string(y), "mousedown",
           std::to_string(button)});
}
void Desk::release(int button) { xdotool({"mouseup", std::to_string(button)}); }

void Desk::drag(int from_x, int from_y, int to_x, int to_y, int button) {
  press(from_x, from_y, button);
  for (int part = 1; part <= 4; ++part) {
    move(from_x + (to_x - from_x) * part / 4, from_y + (to_y - from_y) * part / 4);
  }
  release(button);
}

void Desk::layout(const std::string& name) {
  Child tool({"setxkbmap", name}, environment_, folder_ / "setxkbmap.log");
  if (tool.await_end(30) != 0) fail("setxkbmap " + name + " failed");
}

void Desk::key(const std::string& keysym) { xdotool({"key", "--clearmodifiers", keysym}); }
void Desk::type(const std::string& text) { xdotool({"type", "--delay", "20", "--", text}); }

void Desk::control_click(int x, int y) {
  xdotool({"mousemove", "--window", window_, std::to_string(x), std::to_string(y), "keydown", "ctrl", "click",
           "1", "keyup", "ctrl"});
}

void Desk::resize(int width, int height) {
  xdotool({"windowsize", window_, std::to_string(width), std::to_string(height)});
}

void Desk::minimise() { xdotool({"windowminimize", window_}); }
void Desk::restore() { xdotool({"windowmap", window_, "windowactivate", window_}); }
void Desk::ask_to_close() { xdotool({"windowfocus", window_, "key", "alt+F4"}); }
std::string Desk::title() { return xdotool_output({"getwindowname", window_}); }

Place Desk::control(const std::string& name) {
  const auto end = in(60);
  while (!controls_.contains(name)) {
    const int left = milliseconds_until(end);
    if (left == 0 || !read_lines(left / 1000.0)) fail("no control " + name + " in the window");
  }
  read_lines(0);
  return controls_.at(name);
}

void Desk::click_control(const std::string& name) {
  const auto place = control(name);
  click(place.centre_x(), place.centre_y());
}

/// Xvfb keeps its screen in a file of the XWD format: a header of big-endian words, a table of colours, the
/// pixels.
std::filesystem::path Desk::picture(const std::string& name) {
  std::ifstream file(server_folder_ / "Xvfb_screen0", std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  const auto word = [&](std::size_t k) {
    std::uint32_t value = 0;
    for (std::size_t byte = 0; byte < 4; ++byte)
      value = value << 8 | static_cast<unsigned char>(bytes.at(4 * k + byte));
    return value;
  };
  const std::size_t pixels = word(0) + 12 * word(19);
  const auto width = static_cast<int>(word(4)), height = static_cast<int>(word(5)),
             stride = static_cast<int>(word(12));
  auto* surface = cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(bytes.data() + pixels),
                                                      CAIRO_FORMAT_RGB24, width, height, stride);
  auto path = folder_ / (name + ".png");
  cairo_surface_write_to_png(surface, path.c_str());
  cairo_surface_destroy(surface);
  return path;
}

}  // namespace clapotis::testing
