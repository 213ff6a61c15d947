#pragma once

#include <span>
#include <string_view>

namespace clapotis {

/// The files of a stage that hold its exercises, put into the program when it is built: see embed.cmake.
struct LessonText {
  std::string_view stage, readme, french;
};

std::span<const LessonText> lesson_texts();

}  // namespace clapotis
