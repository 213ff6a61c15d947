#include "common/runner/compare.hpp"

#include "report/stages.hpp"

int main(int argc, char** argv) { return clapotis::run_compare(clapotis::all_stages(), argc, argv); }
