#pragma once

#include <algorithm>
#include <vector>

#include "common/particles/particles.hpp"

namespace clapotis {

/// Calls act(i) for i = 0..n-1, shared between threads. Each i must write only what is its own; then the
/// result does not depend on the number of threads.
template <class Act>
void for_each(Index n, int threads, const Act& act) {
  if (threads == 1 || n < 256) {
    for (Index i = 0; i < n; ++i) act(i);
    return;
  }
#pragma omp parallel for schedule(static) num_threads(threads)
  for (Index i = 0; i < n; ++i) act(i);
}

inline constexpr Index block_size = 4096;
inline std::size_t blocks_of(Index n) { return static_cast<std::size_t>((n + block_size - 1) / block_size); }

/// So few rows are moved sooner than another thread wakes up.
inline constexpr Index worth_waking = 10 * block_size;

/// Calls act(first, count) for blocks of rows that together are 0..n-1, shared between threads.
template <class Act>
void for_blocks(Index n, int threads, const Act& act) {
  if (threads == 1 || n < worth_waking) {
    act(Index{0}, n);
    return;
  }
#pragma omp parallel for schedule(static) num_threads(threads)
  for (Index first = 0; first < n; first += block_size) act(first, std::min(block_size, n - first));
}

/// Sum of term(i, block) over i = 0..n-1. Blocks of fixed size are summed by themselves and then in their
/// order, so that the result is the same bit for bit with any number of threads.
template <class Term>
double sum_over(Index n, int threads, const Term& term) {
  const auto sum_of_block = [&](Index block) {
    double sum = 0;
    const Index last = std::min(n, (block + 1) * block_size);
    for (Index i = block * block_size; i < last; ++i) sum += term(i, static_cast<std::size_t>(block));
    return sum;
  };
  if (n <= block_size) return n > 0 ? sum_of_block(0) : 0;
  const auto blocks = static_cast<Index>(blocks_of(n));
  std::vector<double> sums(static_cast<std::size_t>(blocks));
#pragma omp parallel for schedule(static) num_threads(threads)
  for (Index block = 0; block < blocks; ++block) sums[static_cast<std::size_t>(block)] = sum_of_block(block);
  double sum = 0;
  for (const double s : sums) sum += s;
  return sum;
}

}  // namespace clapotis
