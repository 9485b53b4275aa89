#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// Processes that work on the same task, each with its own samples. Every process must call the
/// same functions in the same order. A process that fails before a call passes its failure to
/// agree(), with which every step ends.
class ProcessGroup {
 public:
  ProcessGroup() = default;
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup(ProcessGroup&&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;
  ProcessGroup& operator=(ProcessGroup&&) = delete;
  virtual ~ProcessGroup() = default;

  /// The number of this process, from 0, and of all processes.
  virtual std::size_t rank() const = 0;
  virtual std::size_t size() const = 0;

  /// Replaces the values by their sums over all processes, modulo 2^64. As many in each process.
  virtual void sum(std::span<std::int64_t> values) = 0;

  /// Replaces the values, which must be finite, by the greatest of all processes.
  virtual void maximize(std::span<double> values) = 0;

  /// Copies the bytes of `process` into those of the first, as many in both. The other processes,
  /// whose bytes are not used, need not wait.
  virtual void bring_to_first(std::size_t process, std::span<char> bytes) = 0;

  bool is_first() const { return rank() == 0; }

  /// Whether agree() has returned a failure.
  bool has_failed() const { return has_failed_; }

  /// Success if every process passes success; otherwise, in every process, the failure of the first
  /// process that passes one.
  Result<void> agree(const Result<void>& own);

  /// The numbers of all processes, in their order.
  std::vector<std::int64_t> gather(std::int64_t own);

  /// The sum of the numbers of the processes before this one.
  std::int64_t sum_before(std::int64_t own);

  /// Calls `next` in one process after another, the first with `value`, each other with the result
  /// of the one before. Returns the last result in every process.
  double in_turn(double value, const std::function<double(double)>& next);

 private:
  std::string from(std::size_t process, const std::string& text);

  bool has_failed_ = false;
};

/// `own` if all `processes` succeed, otherwise the failure of the first that fails. With nullptr
/// there is only this process.
template <typename T>
Result<T> agreed(Result<T> own, ProcessGroup* processes) {
  if (!processes) return own;
  auto all = processes->agree(own ? Result<void>() : fail(own.error()));
  if (!all) return fail(std::move(all.error()));
  return own;
}

}  // namespace somato
