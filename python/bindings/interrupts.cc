#include "interrupts.h"

#include <utility>

namespace somato::python {

bool Interrupts::proceed() {
  if (raised_) return false;
  const auto now = std::chrono::steady_clock::now();
  if (now - checked_ < std::chrono::milliseconds(50)) return true;
  checked_ = now;
  const nanobind::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) raised_.emplace();
  return !raised_;
}

void Interrupts::throw_raised() {
  if (raised_) throw std::move(*raised_);
}

}  // namespace somato::python
