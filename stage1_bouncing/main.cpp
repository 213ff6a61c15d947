#include "common/window/window.hpp"
#include "stage1_bouncing/scenes.hpp"

int main(int argc, char** argv) {
  return clapotis::run_stage(clapotis::stage1::stage(), argc, argv, clapotis::window_door());
}
