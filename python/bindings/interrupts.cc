#include "interrupts.h"

namespace somato::python {

bool Interrupts::proceed() {
  if (!stopped_ && std::this_thread::get_id() == maker_ && is_due(handled_at_)) {
    with_lock([] {
      if (PyErr_CheckSignals() != 0) nanobind::raise_python_error();
    });
  }
  return !stopped_;
}

// The end is always shown.
bool Interrupts::report(std::uint64_t done, std::uint64_t total) {
  if (!proceed()) return false;
  if (!shown_.is_none() && (is_due(shown_at_) || done == total)) {
    with_lock([&] { shown_(done, total); });
  }
  return !stopped_;
}

// The first of several threads finds that enough time has passed.
bool Interrupts::is_due(Moment& last) {
  const Clock::time_point now = Clock::now();
  Clock::time_point before = last;
  return now - before >= std::chrono::milliseconds(50) && last.compare_exchange_strong(before, now);
}

template <typename Work>
void Interrupts::with_lock(const Work& work) {
  const nanobind::gil_scoped_acquire lock;
  try {
    work();
  } catch (nanobind::python_error& raised) {
    if (!raised_) raised_.emplace(std::move(raised));
    stopped_ = true;
  }
}

void Interrupts::throw_raised() {
  if (raised_) throw std::move(*raised_);
}

void unlocked(const std::function<void(Interrupts&)>& work, nanobind::object progress) {
  Interrupts interrupts(std::move(progress));
  {
    const nanobind::gil_scoped_release released;
    work(interrupts);
  }
  interrupts.throw_raised();
}

}  // namespace somato::python
