#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "common/particles/particles.hpp"

namespace clapotis {

/// Rows that go to a thread together. The first half of the blocks goes to the first of two threads, always:
/// what a thread wrote it mostly reads again, and data that changes hands between cores costs more than work.
inline constexpr Index block_size = 256;
inline std::size_t blocks_of(Index n) { return static_cast<std::size_t>((n + block_size - 1) / block_size); }

/// Calls act(block) for 0..blocks-1, shared between threads.
template <class Act>
void for_each_block(Index blocks, int threads, const Act& act) {
  if (threads == 1 || blocks == 1) {
    for (Index block = 0; block < blocks; ++block) act(block);
    return;
  }
#pragma omp parallel for schedule(static) num_threads(threads)
  for (Index block = 0; block < blocks; ++block) act(block);
}

/// Calls act(first, count) for blocks of rows that together are 0..n-1, shared between threads.
template <class Act>
void for_rows(Index n, int threads, const Act& act) {
  for_each_block(static_cast<Index>(blocks_of(n)), threads, [&](Index block) {
    const Index first = block * block_size;
    act(first, std::min(block_size, n - first));
  });
}

/// Calls act(i) for i = 0..n-1, shared between threads. Each i must write only what is its own; then the
/// result does not depend on the number of threads.
template <class Act>
void for_each(Index n, int threads, const Act& act) {
  for_rows(n, threads, [&](Index first, Index count) {
    for (Index i = first; i < first + count; ++i) act(i);
  });
}

/// What term(first, count) gives for each block of rows, in their order, with any number of threads.
template <class Term>
auto of_blocks(Index n, int threads, const Term& term) {
  std::vector<decltype(term(Index{0}, Index{0}))> all(blocks_of(n));
  for_rows(n, threads, [&](Index first, Index count) {
    all[static_cast<std::size_t>(first / block_size)] = term(first, count);
  });
  return all;
}

/// Sum of term(i, block) over i = 0..n-1. Blocks are summed by themselves and then in their order, so that
/// the result is the same bit for bit with any number of threads.
template <class Term>
double sum_over(Index n, int threads, const Term& term) {
  const auto sums = of_blocks(n, threads, [&](Index first, Index count) {
    double sum = 0;
    for (Index i = first; i < first + count; ++i)
      sum += term(i, static_cast<std::size_t>(first / block_size));
    return sum;
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// How many threads to share cheap work between, a few operations a row: few rows are done sooner than
/// another thread wakes up.
inline int threads_for_little(Index rows, int threads) { return rows < 8192 ? 1 : threads; }

}  // namespace clapotis
