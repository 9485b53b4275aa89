#include "views/http/event_hub.h"

#include <algorithm>

namespace somato::live {

void EventHub::publish(EventKind kind, std::string text) {
  publish(kind, std::move(text), false);
}

void EventHub::publish_end(std::string text) {
  publish(EventKind::kFrame, std::move(text), true);
}

void EventHub::publish(EventKind kind, std::string text, bool is_end) {
  auto shared = std::make_shared<const std::string>(std::move(text));
  {
    const std::scoped_lock lock(mutex_);
    Latest& latest = latest_[static_cast<std::size_t>(kind)];
    if (latest.is_end) end_ = std::move(latest);
    latest = {std::move(shared), ++published_, is_end};
  }
  news_.notify_all();
}

EventHub::Text EventHub::latest(EventKind kind) const {
  const std::scoped_lock lock(mutex_);
  return latest_[static_cast<std::size_t>(kind)].text;
}

std::size_t EventHub::viewers() const {
  const std::scoped_lock lock(mutex_);
  return viewers_.size();
}

bool EventHub::acknowledge(std::uint64_t viewer, std::uint64_t number) {
  {
    const std::scoped_lock lock(mutex_);
    const auto found = viewers_.find(viewer);
    if (found == viewers_.end()) return false;
    Subscription& one = *found->second;
    if (number != one.handed_.number || one.acknowledged_ == number) return true;
    one.acknowledged_ = number;
    one.acknowledged_at_ = Clock::now();
  }
  news_.notify_all();
  return true;
}

std::size_t EventHub::left() const {
  const std::scoped_lock lock(mutex_);
  return subscribed_ - viewers_.size();
}

void EventHub::close() {
  {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
  }
  news_.notify_all();
}

bool EventHub::is_closed() const {
  const std::scoped_lock lock(mutex_);
  return closed_;
}

std::unique_ptr<EventHub::Subscription> EventHub::subscribe(std::size_t most, Flow flow) {
  std::unique_ptr<Subscription> subscription;
  {
    const std::scoped_lock lock(mutex_);
    if (viewers_.size() >= most || closed_) return nullptr;
    subscription = std::make_unique<Subscription>(*this, ++subscribed_, flow);
    viewers_.emplace(subscribed_, subscription.get());
  }
  if (changed_) changed_();
  return subscription;
}

void EventHub::leave(std::uint64_t viewer) {
  {
    const std::scoped_lock lock(mutex_);
    viewers_.erase(viewer);
  }
  if (changed_) changed_();
}

bool EventHub::Subscription::has_news() const {
  for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
    if (hub_.latest_[kind].number > seen_[kind]) return true;
  }
  return false;
}

// An end belongs to the state and scene that the viewer has; a new viewer has none.
std::vector<EventHub::Event> EventHub::Subscription::take() {
  constexpr auto kFrame = static_cast<std::size_t>(EventKind::kFrame);
  std::vector<Event> events;
  if (seen_[kFrame] > 0 && hub_.end_.number > seen_[kFrame]) {
    events.emplace_back(EventKind::kFrame, hub_.end_.text);
  }
  for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
    const Latest& latest = hub_.latest_[kind];
    if (latest.number <= seen_[kind]) continue;
    seen_[kind] = latest.number;
    events.emplace_back(static_cast<EventKind>(kind), latest.text);
  }
  return events;
}

void EventHub::Subscription::count() {
  ++handed_.number;
  handed_.waited = Clock::now() - acknowledged_at_;
}

std::optional<std::vector<EventHub::Event>> EventHub::Subscription::next(
    std::chrono::milliseconds patience) {
  std::unique_lock lock(hub_.mutex_);
  hub_.news_.wait_for(lock, patience, [&] { return hub_.closed_ || (is_ready() && has_news()); });
  if (hub_.closed_) return {};
  if (!is_ready()) return std::vector<Event>();
  count();
  return take();
}

void EventHub::Subscription::rest(std::chrono::milliseconds time) const {
  std::unique_lock lock(hub_.mutex_);
  hub_.news_.wait_for(lock, time, [&] { return hub_.closed_; });
}

}  // namespace somato::live
