#pragma once

#include <atomic>
#include <exception>
#include <mutex>

namespace somato {

/// Keeps the first exception of several threads.
class FirstException {
 public:
  template <typename Work>
  void guard(const Work& work) {
    try {
      work();
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!first_) first_ = std::current_exception();
      caught_ = true;
    }
  }

  bool caught() const { return caught_; }

  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr first_;
  std::atomic<bool> caught_ = false;
};

}  // namespace somato
