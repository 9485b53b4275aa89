#include "hardware/topics/topic_client.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>
#include <variant>

#include "somato/core/value.h"

namespace somato::topics {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

using Seconds = std::chrono::duration<double>;

}  // namespace

Result<std::unique_ptr<TopicClient>> TopicClient::start(const std::string& address,
                                                        const TopicLimits& limits) {
  SOMATO_TRY(auto parsed, parse_web_socket_address(address));
  std::unique_ptr<TopicClient> client(new TopicClient(std::move(parsed), address, limits));
  client->thread_ = std::thread([self = client.get()] { self->run(); });
  return client;
}

TopicClient::TopicClient(WebSocketAddress address, std::string text, const TopicLimits& limits)
    : address_(std::move(address)), text_(std::move(text)), limits_(limits) {}

TopicClient::~TopicClient() {
  {
    const std::scoped_lock lock(mutex_);
    stopping_ = true;
    if (socket_) socket_->wake();
  }
  changed_.notify_all();
  thread_.join();
}

void TopicClient::run() {
  for (;;) {
    stay_connected();
    std::unique_lock lock(mutex_);
    std::unique_ptr<WebSocket> ended = std::move(socket_);
    lock.unlock();
    ended.reset();
    lock.lock();
    changed_.wait_for(lock, Seconds(limits_.reconnect), [&] { return stopping_; });
    if (stopping_) return;
  }
}

// Until the connection is lost or the client stops. Events come from serve(), in this thread.
void TopicClient::stay_connected() {
  constexpr double kServeSeconds = 0.1;
  bool closed = false;
  auto made =
      WebSocket::connect(address_, kSubprotocols, limits_.message_bytes,
                         {.on_open =
                              [this] {
                                const std::scoped_lock lock(mutex_);
                                state_.connected = true;
                                ++state_.connections;
                              },
                          .on_text = [this](std::string_view text) { handle_text(text); },
                          .on_bytes = [this](std::string_view bytes) { handle_bytes(bytes); },
                          .on_close =
                              [&](const std::string& reason) {
                                closed = true;
                                forget_connection(reason);
                              }});
  if (!made) return forget_connection(made.error().what);
  WebSocket& socket = **made;
  {
    const std::scoped_lock lock(mutex_);
    socket_ = std::move(*made);
  }
  for (;;) {
    {
      const std::scoped_lock lock(mutex_);
      if (stopping_ || closed) return;
      subscribe_to_new(socket);
    }
    socket.serve(kServeSeconds);
  }
}

void TopicClient::forget_connection(const std::string& reason) {
  {
    const std::scoped_lock lock(mutex_);
    state_.connected = false;
    state_.problem = reason;
    topics_.clear();
    std::fill(subscribed_.begin(), subscribed_.end(), kNone);
  }
  changed_.notify_all();
}

void TopicClient::handle_text(std::string_view text) {
  auto message = parse_server_message(text, text_);
  {
    const std::scoped_lock lock(mutex_);
    if (!message) {
      state_.problem = to_string(message.error());
    } else if (auto* advertised = std::get_if<Advertisement>(&*message)) {
      for (Topic& topic : advertised->topics) topics_[topic.name] = std::move(topic);
    } else if (const auto* withdrawn = std::get_if<Withdrawal>(&*message)) {
      for (const std::uint32_t id : withdrawn->ids) {
        std::erase_if(topics_, [&](const auto& entry) { return entry.second.id == id; });
        std::replace(subscribed_.begin(), subscribed_.end(), id, kNone);
      }
    } else if (const auto* status = std::get_if<ServerStatus>(&*message)) {
      if (status->level > 0) state_.problem = status->message;
    }
  }
  changed_.notify_all();
}

void TopicClient::handle_bytes(std::string_view bytes) {
  const auto message = parse_topic_message(bytes, text_);
  {
    const std::scoped_lock lock(mutex_);
    if (!message) {
      state_.problem = to_string(message.error());
      return;
    }
    if (!*message || (*message)->subscription >= wanted_.size()) return;
    ++state_.received;
    arrivals_.push_back(
        {(*message)->subscription, (*message)->time, std::string((*message)->payload)});
    queued_bytes_ += arrivals_.back().payload.size();
    while (queued_bytes_ > limits_.queue_bytes) {
      queued_bytes_ -= arrivals_.front().payload.size();
      arrivals_.pop_front();
      ++state_.dropped;
    }
  }
  changed_.notify_all();
}

// With the lock. The number of a subscription is the place of its topic among those wanted.
void TopicClient::subscribe_to_new(WebSocket& socket) {
  if (!state_.connected) return;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wanted;
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    const auto found = topics_.find(wanted_[i]);
    if (found == topics_.end() || subscribed_[i] == found->second.id) continue;
    subscribed_[i] = found->second.id;
    wanted.emplace_back(static_cast<std::uint32_t>(i), found->second.id);
  }
  if (!wanted.empty()) socket.send(subscribe_text(wanted));
}

std::vector<std::string> TopicClient::not_advertised(const std::vector<std::string>& names) const {
  std::vector<std::string> missing;
  for (const std::string& name : names) {
    if (!topics_.contains(name)) missing.push_back(name);
  }
  return missing;
}

Error TopicClient::not_found(const std::vector<std::string>& missing) const {
  if (!state_.connected) {
    return {ErrorKind::kSystem,
            "no connection to the topics" +
                (state_.problem.empty() ? std::string() : ": " + state_.problem),
            text_, "check the address, and that the robot's bridge runs"};
  }
  std::vector<std::string> known;
  known.reserve(topics_.size());
  for (const auto& [name, topic] : topics_) known.push_back(name);
  const std::string near = nearest_name(missing.front(), known);
  return {ErrorKind::kUsage, fmt::format("the robot has no topic '{}'", missing.front()), text_,
          near.empty()
              ? fmt::format("its topics are: {}", fmt::join(known, ", "))
              : fmt::format("did you mean '{}'? Its topics are: {}", near, fmt::join(known, ", "))};
}

Result<std::vector<Topic>> TopicClient::subscribe(const std::vector<std::string>& names,
                                                  double seconds) {
  std::unique_lock lock(mutex_);
  wanted_ = names;
  subscribed_.assign(names.size(), kNone);
  if (socket_) socket_->wake();
  changed_.wait_for(lock, Seconds(seconds), [&] { return not_advertised(names).empty(); });
  if (const auto missing = not_advertised(names); !missing.empty()) {
    return fail(not_found(missing));
  }
  std::vector<Topic> found;
  found.reserve(names.size());
  for (const std::string& name : names) found.push_back(topics_.at(name));
  return found;
}

std::vector<Topic> TopicClient::topics() const {
  const std::scoped_lock lock(mutex_);
  std::vector<Topic> all;
  all.reserve(topics_.size());
  for (const auto& [name, topic] : topics_) all.push_back(topic);
  return all;
}

std::deque<Arrival> TopicClient::take(double seconds) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, Seconds(seconds), [&] { return !arrivals_.empty(); });
  queued_bytes_ = 0;
  return std::exchange(arrivals_, {});
}

TopicState TopicClient::state() const {
  const std::scoped_lock lock(mutex_);
  return state_;
}

}  // namespace somato::topics
