#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace clapotis::testing {

/// A process that cannot outlive the test: the kernel kills it should the test die first.
class Child {
 public:
  /// Starts `command` with `environment` added to ours; what it prints goes to `log`. The descriptors in
  /// `keep` stay open in it. It runs in the folder of its log.
  Child(const std::vector<std::string>& command, const std::map<std::string, std::string>& environment,
        const std::filesystem::path& log, const std::vector<int>& keep = {});
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  [[nodiscard]] pid_t id() const { return id_; }
  /// Its exit code once it has ended, 128 + n when signal n ended it. Throws after `seconds`.
  int await_end(double seconds);

 private:
  [[nodiscard]] bool ends_within(double seconds) const;

  pid_t id_ = -1;
  bool ended_ = false;
};

/// A rectangle of the screen [pixel].
struct Place {
  int x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] int centre_x() const { return x + width / 2; }
  [[nodiscard]] int centre_y() const { return y + height / 2; }
};

/// A point of a window [pixel].
struct Pixel {
  int x = 0, y = 0;
};

/// A desk of its own for one test: a private X server of 1280 x 800 pixels, a program in it, and real mouse
/// and key events. The program says through CLAPOTIS_TRACE what its user can see change; a test awaits these
/// lines and never sleeps. Everything is gone when the desk is, and the log and the pictures stay in the
/// build folder.
class Desk {
 public:
  enum class WindowManager { none, openbox };
  /// `name` is that of the test; its log and pictures go to the folder `artefacts`/name.
  explicit Desk(const std::string& name, WindowManager manager = WindowManager::none);
  ~Desk();

  /// `environment` is what the program has besides ours.
  void start(const std::vector<std::string>& command,
             const std::map<std::string, std::string>& environment = {});
  /// Waits for a line that begins with `beginning`, of the frame that was last waited for or of a later one,
  /// and returns the rest of it; no line is returned twice. Throws, with all lines so far, when the program
  /// ends or `seconds` pass.
  std::string await(std::string_view beginning, double seconds = 60);
  /// Whether such a line has come by now, without waiting: of use after an awaited line that must come later.
  [[nodiscard]] bool seen(std::string_view beginning);
  int await_exit(double seconds = 60);
  void interrupt();  ///< Ctrl-C in the terminal it was started from

  void move(int x, int y);                   ///< the mouse, in pixels of the program's window
  void click(int x, int y, int button = 1);  ///< 1 left, 2 middle, 3 right, 4 wheel away, 5 wheel towards
  void press(int x, int y, int button = 1);  ///< and holds it
  void release(int button = 1);
  void drag(int from_x, int from_y, int to_x, int to_y, int button = 1);
  void layout(const std::string& name);  ///< of the keyboard, from now on: "fr"
  void key(const std::string& keysym);   ///< "space", "shift+n", "Page_Down"
  void type(const std::string& text);
  void control_click(int x, int y);
  void resize(int width, int height);
  void minimise();
  void restore();
  void ask_to_close();  ///< the window manager's close button
  [[nodiscard]] std::string title();

  /// Where the program drew the control of that name, in pixels of its window; awaits it.
  Place control(const std::string& name);
  void click_control(const std::string& name);
  /// Where the point (x, y) of a scene of that size, from its lower left corner, is drawn.
  Pixel pixel_of(double x, double y, double scene_width, double scene_height);

  /// Saves what is on the screen as NAME.png.
  std::filesystem::path picture(const std::string& name);
  /// Where the log, the pictures and what the program writes are.
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::string& display() const { return environment_.at("DISPLAY"); }

 private:
  void start_openbox();
  bool read_lines(double seconds);  ///< false when the program has closed its end
  void xdotool(const std::vector<std::string>& words);
  std::string xdotool_output(const std::vector<std::string>& words);
  [[noreturn]] void fail(const std::string& sentence) const;

  std::filesystem::path folder_, server_folder_;
  std::map<std::string, std::string> environment_;
  std::unique_ptr<Child> server_, manager_, program_;
  int trace_ = -1;
  bool trace_open_ = false;
  std::string rest_, window_;
  struct Line {
    std::string text;
    std::size_t frame = 0;
    bool returned = false;
  };
  /// The first line not yet returned that begins so, or the end.
  std::vector<Line>::iterator find(std::string_view beginning);

  std::vector<Line> lines_;
  std::size_t frame_ = 0;  ///< of the line that was last waited for
  std::size_t frames_ended_ = 0;
  std::map<std::string, Place> controls_;
};

}  // namespace clapotis::testing
