#include "common/window/window.hpp"
#include "stage4_sph/scenes.hpp"

int main(int argc, char** argv) {
  return clapotis::run_stage(clapotis::stage4::stage(), argc, argv, clapotis::window_door());
}
