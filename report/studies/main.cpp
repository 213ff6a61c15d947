#include <array>

#include "report/studies/run_studies.hpp"
#include "report/studies/studies.hpp"

int main(int argc, char** argv) {
  using namespace clapotis::studies;
  const std::array studies{
      orders(),
      handout_errata(),
      work_precision_sph(),
      dam_break(),
  };
  return run_studies(studies, argc, argv);
}
