#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <vector>

#include "engine/base/run.h"

namespace remeshd {

/// Elements per block where one costs about 10 ns (a measure), 100 ns (an exact predicate) or 1 us
/// (a search).
inline constexpr std::size_t kCheapBlock = 4096, kFairBlock = 1024, kDearBlock = 512;

/// Calls f(begin, end) for blocks of [0, count), each `block` long but for the last, on up to
/// `run.threads` threads. Blocks do not depend on the number of threads: where none reads what
/// another one writes, the result does not either.
///
/// Where blocks throw, rethrows the exception of the first of them, by its place in the range.
void in_blocks(std::size_t count, std::size_t block, const Run& run,
               const std::function<void(std::size_t begin, std::size_t end)>& f);

/// Like in_blocks, where f(begin, end, found) appends what a block finds to `found`. Returns all of
/// it in the order of the blocks.
template <class T, class F>
std::vector<T> collect_in_blocks(std::size_t count, std::size_t block, const Run& run, F&& f) {
  std::vector<std::vector<T>> found((count + block - 1) / block);
  in_blocks(count, block, run,
            [&](std::size_t begin, std::size_t end) { f(begin, end, found[begin / block]); });
  if (found.size() == 1) return std::move(found.front());
  std::size_t size = 0;
  for (const auto& part : found) size += part.size();
  std::vector<T> all;
  all.reserve(size);
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Calls all of the tasks, on up to `run.threads` threads. None may read what another one writes.
/// Where tasks throw, rethrows the exception of the first of them in the list.
void side_by_side(std::initializer_list<std::function<void()>> tasks, const Run& run);

}  // namespace remeshd
