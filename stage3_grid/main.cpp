#include "common/runner/run_stage.hpp"
#include "stage3_grid/scenes.hpp"

int main(int argc, char** argv) { return clapotis::run_stage(clapotis::stage3::stage(), argc, argv); }
