#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace clapotis {

/// The compiler, its number and what it was asked for, for example "g++ 12.2.0, vectors of 8".
std::string compiler();
/// The processor's name as the system tells it.
std::string processor();
/// FNV-1a of 64 bits (Fowler, Noll & Vo): tells whether bytes are still the same, not who wrote them.
std::uint64_t fingerprint(std::string_view bytes);
/// That of this program's own file, in hexadecimal digits; where the system does not show it, the compiler.
std::string program_fingerprint();
/// The most memory that this program has held so far [byte].
std::size_t peak_memory_bytes();

}  // namespace clapotis
