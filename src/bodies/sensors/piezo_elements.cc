#include "bodies/sensors/piezo_elements.h"

#include <cmath>

namespace somato::detail {
namespace {

// A signal below it is 0: it changes no reading, and numbers near the smallest are slow.
constexpr double kSilent = 1e-60;

double next_signal(double kept, double signal, double force, double before) {
  const double next = kept * (signal + force - before);
  return std::abs(next) < kSilent ? 0.0 : next;
}

}  // namespace

void PiezoElements::step(const std::vector<double>& forces, double seconds) {
  const double kept = this->kept(seconds);
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    signals_[i] = next_signal(kept, signals_[i], forces[i], forces_[i]);
    forces_[i] = forces[i];
  }
}

void PiezoElements::advance(std::size_t element, std::uint64_t still, double force,
                            double seconds) {
  rest(element, still, seconds);
  signals_[element] = next_signal(kept(seconds), signals_[element], force, forces_[element]);
  forces_[element] = force;
}

void PiezoElements::rest(std::size_t element, std::uint64_t still, double seconds) {
  const double kept = this->kept(seconds);
  const double force = forces_[element];
  double signal = signals_[element];
  for (; still > 0 && signal != 0.0; --still) signal = next_signal(kept, signal, force, force);
  signals_[element] = signal;
}

}  // namespace somato::detail
