#include <array>

#include "report/studies/run_studies.hpp"
#include "report/studies/studies.hpp"

int main(int argc, char** argv) {
  using namespace clapotis::studies;
  const std::array studies{
      orders(),
      work_precision_bounce(),
      work_precision_spring(),
      list_or_grid(),
      handout_errata(),
      stability_map(),
      work_precision_sph(),
      dam_break(),
      sloshing(),
      standing_wave(),
      capillarity(),
      honey(),
      jet(),
      pay_for_what_you_use(),
      scaling(),
      long_run(),
      hard_cases(),
      window_times(),
  };
  return run_studies(studies, argc, argv);
}
