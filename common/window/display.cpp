#include "common/window/display.hpp"

#if defined(__unix__) && !defined(__APPLE__)
#include <dlfcn.h>

#include <cstdlib>
#include <memory>
#endif

namespace clapotis {

#if defined(__unix__) && !defined(__APPLE__)
bool display_available() {
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name) return false;
  const std::unique_ptr<void, int (*)(void*)> library(
      dlopen("libX11.so.6", RTLD_NOW), [](void* handle) { return handle ? dlclose(handle) : 0; });
  if (!library) return false;
  // The two functions' C prototypes, with the Display structure left opaque.
  const auto open_display = reinterpret_cast<void* (*)(const char*)>(dlsym(library.get(), "XOpenDisplay"));
  const auto close_display = reinterpret_cast<int (*)(void*)>(dlsym(library.get(), "XCloseDisplay"));
  if (!open_display || !close_display) return false;
  void* display = open_display(nullptr);
  if (!display) return false;
  close_display(display);
  return true;
}
#else
bool display_available() { return true; }  // Windows and macOS always have one
#endif

}  // namespace clapotis
