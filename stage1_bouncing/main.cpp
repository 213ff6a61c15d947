#include "common/runner/run_stage.hpp"
#include "stage1_bouncing/scenes.hpp"

int main(int argc, char** argv) { return clapotis::run_stage(clapotis::stage1::stage(), argc, argv); }
