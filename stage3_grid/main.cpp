#include "common/window/window.hpp"
#include "stage3_grid/scenes.hpp"

int main(int argc, char** argv) {
  return clapotis::run_stage(clapotis::stage3::stage(), argc, argv, clapotis::window_door());
}
