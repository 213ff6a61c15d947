#pragma once

#include <string>
#include <vector>

namespace clapotis {

struct Variable {
  std::string variable;  ///< CLAPOTIS_GRAVITY
  std::string name;      ///< gravity
  std::string value;
};

/// What the environment gives: all CLAPOTIS_*, sorted by name.
std::vector<Variable> environment();

}  // namespace clapotis
