#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace somato::live {

/// What is told to those who look on, in the order in which it is told when there is more than one.
enum class EventKind { kState, kScene, kTraining, kFrame };
inline constexpr std::size_t kEventKinds = 4;

/// Hands the latest of each kind of event to any number of lookers-on. Whoever publishes never
/// waits: a looker-on that is slow misses what came in between.
class EventHub {
 public:
  using Text = std::shared_ptr<const std::string>;
  using Event = std::pair<EventKind, Text>;

  /// Called whenever the number of lookers-on has changed, by their threads; before anyone is here.
  void on_change(std::function<void()> changed) { changed_ = std::move(changed); }

  void publish(EventKind kind, std::string text);

  /// The latest of a kind; nullptr before the first.
  Text latest(EventKind kind) const;

  std::size_t lookers_on() const;

  /// Makes everybody leave, now and later.
  void close();
  bool is_closed() const;

  /// Somebody who looks on; used by one thread. It must not outlive the hub.
  class Seat {
   public:
    explicit Seat(EventHub& hub) : hub_(hub) {}
    Seat(const Seat&) = delete;
    Seat(Seat&&) = delete;
    Seat& operator=(const Seat&) = delete;
    Seat& operator=(Seat&&) = delete;
    ~Seat() { hub_.leave(); }

    /// What has come since the last call: of each kind the latest alone. Empty when nothing has
    /// come for `patience`; nothing once the hub is closed.
    std::optional<std::vector<Event>> next(std::chrono::milliseconds patience);

   private:
    EventHub& hub_;
    std::array<std::uint64_t, kEventKinds> seen_{};
  };

  /// A seat, or nullptr when `most` are taken.
  std::unique_ptr<Seat> take_seat(std::size_t most);

 private:
  struct Latest {
    Text text;
    std::uint64_t number = 0;
  };

  void leave();
  bool has_news(const std::array<std::uint64_t, kEventKinds>& seen) const;

  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::array<Latest, kEventKinds> latest_;
  std::uint64_t published_ = 0;
  std::size_t lookers_on_ = 0;
  bool closed_ = false;
  std::function<void()> changed_;
};

}  // namespace somato::live
