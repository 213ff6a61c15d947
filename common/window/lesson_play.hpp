#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/lesson/findings.hpp"
#include "common/window/session.hpp"

namespace clapotis {

/// The exercises of a stage as a class goes through them. Knows no window.
class LessonPlay {
 public:
  enum class Progress { none, running, done, changed };

  explicit LessonPlay(const Stage& stage);
  LessonPlay(const LessonPlay&) = delete;
  LessonPlay& operator=(const LessonPlay&) = delete;

  [[nodiscard]] bool empty() const { return exercises_.empty(); }
  [[nodiscard]] std::size_t count() const { return exercises_.size(); }
  [[nodiscard]] std::size_t place() const { return place_; }
  [[nodiscard]] const Exercise& exercise() const { return exercises_[place_]; }
  [[nodiscard]] const Findings& findings() const { return pages_[place_].findings; }
  [[nodiscard]] bool answer_shown() const { return pages_[place_].answer_shown; }
  void toggle_answer() { pages_[place_].answer_shown = !pages_[place_].answer_shown; }
  /// To the next or the previous exercise; stays at either end.
  void turn(int pages);

  /// Whether the window can do what that line says: a run of this stage.
  [[nodiscard]] bool can_start(const LessonRun& run) const;
  /// Sets the scene as the command says and starts it, at a speed that makes it last some seconds. Throws
  /// BadInput.
  void start(std::size_t run, Session& session);
  /// Of that run of this exercise; `changed`: something was set by hand before it had ended.
  [[nodiscard]] Progress progress(std::size_t run) const;
  /// Once a frame, before inputs are handled: sees that the run was changed, or diverged.
  void follow(Session& session);

 private:
  struct Page {
    Findings findings;
    bool answer_shown = false;
    std::vector<Progress> progress;
  };
  /// The run that was started last, as long as it is what its command says.
  struct Current {
    std::size_t page, run;
    long start = 0;
    std::string integrator;
    Overrides parameters;
  };
  void finish(Progress progress);
  [[nodiscard]] bool is_unchanged(const Session& session) const;

  const Stage& stage_;
  const std::vector<Exercise>& exercises_;
  std::vector<Page> pages_;
  std::size_t place_ = 0;
  std::optional<Current> current_;
};

}  // namespace clapotis
