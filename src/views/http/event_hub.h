#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
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
/// viewer misses the events in between, except the last frame of an exploration, which is handed to
/// it before a later one.
class EventHub {
 public:
  using Text = std::shared_ptr<const std::string>;
  using Event = std::pair<EventKind, Text>;
  using Clock = std::chrono::steady_clock;

  /// Whether events wait until a viewer has acknowledged those before. Buffers between the program
  /// and the viewer, such as those of a tunnel, then hold at most the events of one call of next().
  enum class Flow { kFree, kAcknowledged };

  /// Called whenever the number of viewers has changed, by their threads; to be set before the
  /// first.
  void on_change(std::function<void()> changed) { changed_ = std::move(changed); }

  void publish(EventKind kind, std::string text);

  /// Publishes the last frame of an exploration. If several are missed, the latest of them is kept.
  void publish_end(std::string text);

  /// The latest of a kind; nullptr before the first.
  Text latest(EventKind kind) const;

  std::size_t viewers() const;

  /// The number of viewers whose connection has ended. From any thread.
  std::size_t left() const;

  /// Viewer `viewer` has received the events up to those with this number. Returns whether there is
  /// such a viewer; from any thread.
  bool acknowledge(std::uint64_t viewer, std::uint64_t number);

  /// Ends all subscriptions, now and later.
  void close();
  bool is_closed() const;

  /// The events that were handed to a viewer last.
  struct Handed {
    std::uint64_t viewer = 0;  ///< From 1.
    std::uint64_t number = 0;  ///< Counts the calls of next() that handed out what was latest.
    /// Time from the acknowledgement of the events before (of the first: from the subscription)
    /// until these were handed out.
    Clock::duration waited{};
  };

  /// A viewer's subscription; used by one thread. It must not outlive the hub.
  class Subscription {
   public:
    Subscription(EventHub& hub, std::uint64_t viewer, Flow flow)
        : hub_(hub), flow_(flow), handed_{viewer, 0, {}} {}
    Subscription(const Subscription&) = delete;
    Subscription(Subscription&&) = delete;
    Subscription& operator=(const Subscription&) = delete;
    Subscription& operator=(Subscription&&) = delete;
    ~Subscription() { hub_.leave(handed_.viewer); }

    /// The events since the last call: only the latest of each kind. Empty after `patience` without
    /// events, or without the acknowledgement of those before; nothing once the hub is closed.
    std::optional<std::vector<Event>> next(std::chrono::milliseconds patience);

    /// Describes what the last call of next() handed out, or what still awaits an acknowledgement.
    const Handed& handed() const { return handed_; }

    Flow flow() const { return flow_; }

    /// Waits for so long, or until the hub is closed.
    void rest(std::chrono::milliseconds time) const;

   private:
    friend class EventHub;

    // Functions and fields under the hub's mutex.
    bool is_ready() const { return flow_ == Flow::kFree || acknowledged_ == handed_.number; }
    bool has_news() const;
    std::vector<Event> take();
    void count();

    EventHub& hub_;
    Flow flow_;
    Handed handed_;
    std::uint64_t acknowledged_ = 0;
    Clock::time_point acknowledged_at_ = Clock::now();
    std::array<std::uint64_t, kEventKinds> seen_{};
  };

  /// A subscription, or nullptr when there are `most` already.
  std::unique_ptr<Subscription> subscribe(std::size_t most, Flow flow = Flow::kFree);

 private:
  struct Latest {
    Text text;
    std::uint64_t number = 0;
    bool is_end = false;
  };

  void publish(EventKind kind, std::string text, bool is_end);
  void leave(std::uint64_t viewer);

  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::array<Latest, kEventKinds> latest_;
  Latest end_;  // the latest end that another frame followed
  std::uint64_t published_ = 0;
  std::uint64_t subscribed_ = 0;
  std::map<std::uint64_t, Subscription*> viewers_;
  bool closed_ = false;
  std::function<void()> changed_;
};

}  // namespace somato::live
