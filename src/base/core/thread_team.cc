#include "base/core/thread_team.h"

#include <algorithm>
#include <chrono>

#include "base/core/first_exception.h"
#include "base/core/threads.h"

namespace somato {
namespace {

// The parts of a team's state.
constexpr std::uint32_t kHelper = 1;
constexpr std::uint32_t kHelpers = 0x3FFF;
constexpr std::uint32_t kEnds = 0x4000;
constexpr std::uint32_t kOpen = 0x8000;
constexpr std::uint32_t kJob = 0x10000;

// Falling asleep and being woken takes about as long.
constexpr std::chrono::microseconds kAwake{50};

// The time for which a member waits awake for a job.
constexpr std::chrono::microseconds kLate{1};

// Number of polls between two readings of the clock.
constexpr int kPauses = 4;

using Clock = std::chrono::steady_clock;

std::uint32_t job_of(std::uint32_t state) {
  return state / kJob;
}

// Leaves the core's resources to another thread of it.
void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

// True once `done()` is; false if that takes longer.
template <typename Done>
bool wait_awake(const Done& done, std::chrono::nanoseconds longest) {
  const auto begin = Clock::now();
  do {
    for (int i = 0; i < kPauses; ++i) {
      if (done()) return true;
      pause();
    }
  } while (Clock::now() - begin < longest);
  return done();
}

}  // namespace

ThreadTeam::ThreadTeam(std::size_t threads)
    : parts_(std::clamp<std::size_t>(threads, 1, kHelpers)) {}

ThreadTeam::~ThreadTeam() {
  state_ |= kEnds;
  state_.notify_all();
}

void ThreadTeam::start() {
  helpers_.reserve(size() - 1);
  for (std::size_t member = helpers_.size() + 1; member < size(); ++member) {
    helpers_.emplace_back([this, member] { help(member); });
  }
}

void ThreadTeam::for_each(std::size_t count, const std::function<void(std::size_t)>& work,
                          Order order) {
  if (size() == 1 || count <= 1 || busy_.exchange(true)) {
    for (std::size_t i = 0; i < count; ++i) work(order == Order::kUp ? i : count - 1 - i);
    return;
  }
  FirstException exception;
  exception.guard([&] { start(); });
  if (!exception.caught()) {
    open(count, work, order, exception);
    work_from(0);
    close();
  }
  busy_ = false;
  exception.rethrow();
}

// No thread is in a closed job, so no thread reads what is written here.
void ThreadTeam::open(std::size_t count, const std::function<void(std::size_t)>& work, Order order,
                      FirstException& exception) {
  work_ = &work;
  order_ = order;
  exception_ = &exception;
  for (std::size_t member = 0; member < size(); ++member) {
    parts_[member].begin = count * member / size();
    parts_[member].end = count * (member + 1) / size();
    parts_[member].begun.store(0, std::memory_order_relaxed);
    parts_[member].attended.store(false, std::memory_order_relaxed);
  }
  state_ += kJob + kOpen;
  state_.notify_all();
}

// No helper can come in from now on; those that are in finish their tasks.
void ThreadTeam::close() {
  state_ &= ~kOpen;
  const auto empty = [&] { return (state_ & kHelpers) == 0; };
  if (wait_awake(empty, kAwake)) return;
  caller_sleeps_ = true;
  for (std::uint32_t state = state_; (state & kHelpers) != 0; state = state_) state_.wait(state);
  caller_sleeps_ = false;
}

void ThreadTeam::help(std::size_t member) {
  std::uint32_t seen = 0;
  while ((state_ & kEnds) == 0) {
    if (!enter(seen)) continue;
    work_from(member);
    leave();
  }
}

// Waits for another job than the one `seen`, or the end; true if the helper is in a job.
bool ThreadTeam::enter(std::uint32_t& seen) {
  const auto should_continue = [&](std::uint32_t state) {
    return job_of(state) != seen || (state & kEnds) != 0;
  };
  if (!wait_awake([&] { return should_continue(state_); }, kAwake)) {
    for (std::uint32_t state = state_; !should_continue(state); state = state_) state_.wait(state);
  }
  std::uint32_t state = state_;
  seen = job_of(state);
  while ((state & kOpen) != 0 && job_of(state) == seen) {
    if (state_.compare_exchange_weak(state, state + kHelper)) return true;
  }
  return false;
}

void ThreadTeam::leave() {
  state_ -= kHelper;
  if (caller_sleeps_) state_.notify_all();
}

// Its own tasks, then those of the others.
void ThreadTeam::work_from(std::size_t member) {
  const auto begin = Clock::now();
  Part& own = parts_[member];
  own.attended.store(true, std::memory_order_relaxed);
  while (work_on(own)) continue;
  const std::size_t tasks = std::max<std::size_t>(1, own.end - own.begin);
  const auto patience = 2 * (Clock::now() - begin) / tasks + kLate;
  for (std::size_t i = 1; i < size(); ++i) take_over(parts_[(member + i) % size()], patience);
}

// Leaves the tasks to their own member as long as it continues with them.
void ThreadTeam::take_over(Part& part, std::chrono::nanoseconds patience) {
  const auto attended = [&] { return part.attended.load(std::memory_order_relaxed); };
  if (!wait_awake(attended, kLate)) patience = {};
  std::size_t begun = part.begun.load(std::memory_order_relaxed);
  while (begun < part.end - part.begin) {
    const auto should_continue = [&] {
      return part.begun.load(std::memory_order_relaxed) != begun;
    };
    if (!wait_awake(should_continue, patience)) {
      while (work_on(part)) continue;
      return;
    }
    begun = part.begun.load(std::memory_order_relaxed);
  }
}

// Does a task of the part; false if there is none.
bool ThreadTeam::work_on(Part& part) {
  const std::size_t tasks = part.end - part.begin;
  if (part.begun.load(std::memory_order_relaxed) >= tasks || exception_->caught()) return false;
  const std::size_t number = part.begun.fetch_add(1, std::memory_order_relaxed);
  if (number >= tasks) return false;
  const std::size_t task = order_ == Order::kUp ? part.begin + number : part.end - 1 - number;
  exception_->guard([&] { (*work_)(task); });
  return true;
}

}  // namespace somato
