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

/// Kinds of events, in the order in which a viewer gets them when there are several.
enum class EventKind { kState, kScene, kTraining, kFrame };
inline constexpr std::size_t kEventKinds = 4;

/// Hands the latest of each kind of event to any number of viewers. Publishing never waits: a slow
/// viewer misses the events in between.
class EventHub {
 public:
  using Text = std::shared_ptr<const std::string>;
  using Event = std::pair<EventKind, Text>;

  /// Called whenever the number of viewers has changed, by their threads; to be set before the
  /// first.
  void on_change(std::function<void()> changed) { changed_ = std::move(changed); }

  void publish(EventKind kind, std::string text);

  /// The latest of a kind; nullptr before the first.
  Text latest(EventKind kind) const;

  std::size_t viewers() const;

  /// Ends all subscriptions, now and later.
  void close();
  bool is_closed() const;

  /// A viewer's subscription; used by one thread. It must not outlive the hub.
  class Subscription {
   public:
    explicit Subscription(EventHub& hub) : hub_(hub) {}
    Subscription(const Subscription&) = delete;
    Subscription(Subscription&&) = delete;
    Subscription& operator=(const Subscription&) = delete;
    Subscription& operator=(Subscription&&) = delete;
    ~Subscription() { hub_.leave(); }

    /// The events since the last call: only the latest of each kind. Empty after `patience` without
    /// events; nothing once the hub is closed.
    std::optional<std::vector<Event>> next(std::chrono::milliseconds patience);

   private:
    EventHub& hub_;
    std::array<std::uint64_t, kEventKinds> seen_{};
  };

  /// A subscription, or nullptr when there are `most` already.
  std::unique_ptr<Subscription> subscribe(std::size_t most);

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
  std::size_t viewers_ = 0;
  bool closed_ = false;
  std::function<void()> changed_;
};

}  // namespace somato::live
