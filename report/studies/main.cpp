#include <array>

#include "report/studies/run_studies.hpp"
#include "report/studies/studies.hpp"

int main(int argc, char** argv) {
  using namespace clapotis::studies;
  const std::array studies{
      orders(), list_or_grid(), pay_for_what_you_use(), scaling(), hard_cases(),
  };
  return run_studies(studies, argc, argv);
}
