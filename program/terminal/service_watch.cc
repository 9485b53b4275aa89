#include "terminal/service_watch.h"

#include <fmt/format.h>

#include <cstdio>

namespace somato::program {

void ServiceWatch::look(Clock::time_point now) {
  if (!manager_.patience()) return;
  if (responded_ && !*responded_) return;
  if (next_ && now < *next_) return;
  if (responded_) {
    const auto notified = manager_.notify("WATCHDOG=1");
    if (!notified && !std::exchange(is_reported_, true)) {
      fmt::print(stderr, "somato: {}\n", to_string(notified.error()));
    }
  }
  ask(now);
}

// The task may outlive this object, in a queue that is closed.
void ServiceWatch::ask(Clock::time_point now) {
  responded_ = std::make_shared<std::atomic<bool>>(false);
  next_ = now + *manager_.patience() / 4;
  if (!post_([responded = responded_] { *responded = true; })) responded_.reset();
}

// A manager that has gone changes nothing about the end.
void ServiceWatch::end() const {
  (void)manager_.notify("STOPPING=1");
}

}  // namespace somato::program
