#include <array>

#include "report/studies/run_studies.hpp"
#include "report/studies/studies.hpp"

int main(int argc, char** argv) {
  using namespace clapotis::studies;
  const std::array studies{
      orders(), sloshing(), standing_wave(), capillarity(), honey(), jet(),
  };
  return run_studies(studies, argc, argv);
}
