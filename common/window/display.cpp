#include "common/window/display.hpp"

#if defined(__unix__) && !defined(__APPLE__)
#include <dlfcn.h>

#include <cstdlib>
#endif

namespace clapotis {

#if defined(__unix__) && !defined(__APPLE__)
bool display_available() {
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name) return false;
  void* library = dlopen("libX11.so.6", RTLD_NOW);
  if (!library) return false;
  // The function's C prototype, with the Display structure left opaque.
  const auto open_display = reinterpret_cast<void* (*)(const char*)>(dlsym(library, "XOpenDisplay"));
  // The connection stays open until the program ends: a server whose last client leaves starts anew, and
  // would refuse the one that SFML asks for next.
  static void* display = nullptr;
  if (!display && open_display) display = open_display(nullptr);
  return display != nullptr;
}
#else
bool display_available() { return true; }  // Windows and macOS always have one
#endif

}  // namespace clapotis
