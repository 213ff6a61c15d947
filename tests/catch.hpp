#pragma once

// One Catch2 for every test: 3.x where it is installed, else the single header of 2.x (Debian 12).
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#include <string>
namespace Catch::Matchers {
inline auto ContainsSubstring(const std::string& part) { return Contains(part); }  // its name in 3.x
}  // namespace Catch::Matchers
#endif
