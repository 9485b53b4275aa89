#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// Decides when a training of automatic length (SomParameters::tolerance) ends, from the
/// quantization errors that its checks find after the epochs or iterations of its schedule. A check
/// improves if its error is below (1 - tolerance) times the least error that counts: that of the
/// first check, then of each one that improves.
class LengthChecks {
 public:
  /// The state, from which an interrupted training continues.
  struct State {
    std::uint64_t checks = 0;
    std::uint64_t without_improvement = 0;  ///< Consecutive checks.
    double least_error = 0.0;
  };

  explicit LengthChecks(const SomParameters& parameters)
      : tolerance_(parameters.tolerance),
        patience_(parameters.patience),
        most_checks_(parameters.is_length_automatic() ? parameters.most_checks : 0) {}

  void restore(const State& state) { state_ = state; }

  /// Whether training continues after its schedule; false if its length is not automatic.
  bool go_on() const { return checks_left() > 0; }

  void add(double error);

  /// The number of checks until the end if none improves.
  std::uint64_t checks_left() const;

  const State& state() const { return state_; }

 private:
  double tolerance_;
  std::uint64_t patience_;
  std::uint64_t most_checks_;  // 0 if the length is not automatic
  State state_;
};

/// The mean distance from their winners of the samples with these numbers: samples as `som` sees
/// them, or those that it knows. The same bits for every number of threads.
double mean_distance(const Som& som, const Samples& samples, std::span<const std::size_t> numbers,
                     std::size_t threads);

}  // namespace somato
