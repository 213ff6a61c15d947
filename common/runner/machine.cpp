#include "common/runner/machine.hpp"

#include <fmt/core.h>
#include <sys/resource.h>
#include <sys/utsname.h>

#include <fstream>
#include <sstream>

#include "common/particles/pack.hpp"

namespace clapotis {

std::string compiler() {
#if defined(__clang__)
  const auto name = fmt::format("clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  const auto name = fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
#if defined(__OPTIMIZE__)
  return fmt::format("{}, optimized, vectors of {}", name, pack_width);
#else
  return fmt::format("{}, not optimized, vectors of {}", name, pack_width);
#endif
}

std::string processor() {
  std::ifstream table("/proc/cpuinfo");
  for (std::string line; std::getline(table, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  utsname machine{};
  return uname(&machine) == 0 ? machine.machine : "unknown";
}

std::uint64_t fingerprint(std::string_view bytes) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return sum;
}

std::string program_fingerprint() {
  static const std::string once = [] {
    std::ifstream program("/proc/self/exe", std::ios::binary);
    if (!program) return compiler();
    std::ostringstream bytes;
    bytes << program.rdbuf();
    return fmt::format("{:016x}", fingerprint(bytes.view()));
  }();
  return once;
}

std::size_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace clapotis
