#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace somato::detail {

/// Piezo elements with a charge amplifier: recent changes of a force, decaying with a time
/// constant; a first-order high-pass filter.
class PiezoElements {
 public:
  PiezoElements(std::size_t count, double time_constant)
      : time_constant_(time_constant), forces_(count, 0.0), signals_(count, 0.0) {}

  /// Advances by `seconds`, with these forces at the end.
  void step(const std::vector<double>& forces, double seconds);

  /// Advances one element by `seconds` with this force at the end, after `still` such steps in
  /// which its force did not change: the same bits as so many calls of step().
  void advance(std::size_t element, std::uint64_t still, double force, double seconds);

  /// Advances one element by `still` steps in which its force does not change.
  void rest(std::size_t element, std::uint64_t still, double seconds);

  const std::vector<double>& signals() const { return signals_; }
  const std::vector<double>& forces() const { return forces_; }

 private:
  double kept(double seconds) const { return time_constant_ / (time_constant_ + seconds); }

  double time_constant_;
  std::vector<double> forces_;
  std::vector<double> signals_;
};

}  // namespace somato::detail
