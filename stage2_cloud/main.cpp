#include "common/window/window.hpp"
#include "stage2_cloud/scenes.hpp"

int main(int argc, char** argv) {
  return clapotis::run_stage(clapotis::stage2::stage(), argc, argv, clapotis::window_door());
}
