#pragma once

#include <cstddef>
#include <string>

namespace clapotis {

/// The compiler, its number and what it was asked for, for example "g++ 12.2.0, vectors of 8".
std::string compiler();
/// The processor's name as the system tells it.
std::string processor();
/// The most memory that this program has held so far [byte].
std::size_t peak_memory_bytes();

}  // namespace clapotis
