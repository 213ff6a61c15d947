#pragma once

#include <string>

#include "tests/catch.hpp"
#include "tests/common/process.hpp"

namespace clapotis::testing {

inline const std::string stage1 = STAGE1_PROGRAM, stage2 = STAGE2_PROGRAM, stage3 = STAGE3_PROGRAM,
                         stage4 = STAGE4_PROGRAM, stage5 = STAGE5_PROGRAM, compare = COMPARE_PROGRAM;

inline void require_done(const Ended& ended) {
  INFO(ended.err);
  REQUIRE(ended.code == 0);
}

}  // namespace clapotis::testing
