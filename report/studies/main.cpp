#include <array>

#include "report/studies/run_studies.hpp"
#include "report/studies/studies.hpp"

int main(int argc, char** argv) {
  using namespace clapotis::studies;
  const std::array studies{
      orders(), work_precision_bounce(), work_precision_spring(), stability_map(), long_run(),
  };
  return run_studies(studies, argc, argv);
}
