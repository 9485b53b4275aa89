#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "hardware/topics/foxglove_messages.h"
#include "hardware/topics/web_socket.h"
#include "somato/core/result.h"

namespace somato::topics {

/// Limits against a server that sends more than can be used.
struct TopicLimits {
  std::size_t message_bytes = std::size_t{64} << 20;  ///< A longer message ends the connection.
  std::size_t queue_bytes = std::size_t{256} << 20;   ///< The oldest messages are then dropped.
  double reconnect = 0.5;                             ///< Seconds before the next attempt.
};

/// A message that has arrived.
struct Arrival {
  std::size_t topic = 0;   ///< The place of its topic among those wanted.
  std::uint64_t time = 0;  ///< Nanoseconds by the server's clock.
  std::string payload;
};

/// The state of a client, with numbers since it was started.
struct TopicState {
  bool connected = false;
  std::size_t connections = 0;
  std::size_t received = 0;  ///< Messages of wanted topics.
  std::size_t dropped = 0;   ///< Messages that arrived while the queue was full.
  std::string problem;       ///< The last one, such as the reason of a lost connection; or empty.
};

/// Receives messages of topics from a server of the Foxglove WebSocket protocol, in a separate
/// thread. A connection that is lost is opened again, and the topics are subscribed to again.
/// Functions may be called by one other thread.
class TopicClient {
 public:
  /// Begins to connect to `address`, such as "ws://robot:8765". Errors (kUsage): the address.
  static Result<std::unique_ptr<TopicClient>> start(const std::string& address,
                                                    const TopicLimits& limits = {});

  TopicClient(const TopicClient&) = delete;
  TopicClient(TopicClient&&) = delete;
  TopicClient& operator=(const TopicClient&) = delete;
  TopicClient& operator=(TopicClient&&) = delete;
  ~TopicClient();

  /// Waits until all topics of `names` are advertised, subscribes to them and returns them in that
  /// order; names occur once. Errors (kSystem): no connection within `seconds`; (kUsage): a topic
  /// that is not advertised, with the nearest name and those that are.
  Result<std::vector<Topic>> subscribe(const std::vector<std::string>& names, double seconds);

  /// All topics that the server advertises now.
  std::vector<Topic> topics() const;

  /// The messages that have arrived, in their order; waits for the first for at most `seconds`.
  std::deque<Arrival> take(double seconds);

  TopicState state() const;

 private:
  TopicClient(WebSocketAddress address, std::string text, const TopicLimits& limits);

  void run();
  void stay_connected();
  void handle_text(std::string_view text);
  void handle_bytes(std::string_view bytes);
  void forget_connection(const std::string& reason);
  void subscribe_to_new(WebSocket& socket);
  std::vector<std::string> not_advertised(const std::vector<std::string>& names) const;
  Error not_found(const std::vector<std::string>& missing) const;

  WebSocketAddress address_;
  std::string text_;
  TopicLimits limits_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, Topic> topics_;    // by name
  std::vector<std::string> wanted_;        // in the order of their subscriptions
  std::vector<std::uint32_t> subscribed_;  // the topic's number of each; kNone: not yet
  std::deque<Arrival> arrivals_;
  std::size_t queued_bytes_ = 0;
  TopicState state_;

  std::unique_ptr<WebSocket> socket_;  // replaced by the thread, woken by others
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace somato::topics
