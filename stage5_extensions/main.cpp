#include "common/window/window.hpp"
#include "stage5_extensions/scenes.hpp"

int main(int argc, char** argv) {
  return clapotis::run_stage(clapotis::stage5::stage(), argc, argv, clapotis::window_door());
}
