#include "views/http/event_hub.h"

#include <algorithm>

namespace somato::live {

void EventHub::publish(EventKind kind, std::string text) {
  auto shared = std::make_shared<const std::string>(std::move(text));
  {
    const std::scoped_lock lock(mutex_);
    latest_[static_cast<std::size_t>(kind)] = {std::move(shared), ++published_};
  }
  news_.notify_all();
}

EventHub::Text EventHub::latest(EventKind kind) const {
  const std::scoped_lock lock(mutex_);
  return latest_[static_cast<std::size_t>(kind)].text;
}

std::size_t EventHub::viewers() const {
  const std::scoped_lock lock(mutex_);
  return viewers_;
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

std::unique_ptr<EventHub::Subscription> EventHub::subscribe(std::size_t most) {
  {
    const std::scoped_lock lock(mutex_);
    if (viewers_ >= most || closed_) return nullptr;
    ++viewers_;
  }
  if (changed_) changed_();
  return std::make_unique<Subscription>(*this);
}

void EventHub::leave() {
  {
    const std::scoped_lock lock(mutex_);
    --viewers_;
  }
  if (changed_) changed_();
}

bool EventHub::has_news(const std::array<std::uint64_t, kEventKinds>& seen) const {
  for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
    if (latest_[kind].number > seen[kind]) return true;
  }
  return false;
}

std::optional<std::vector<EventHub::Event>> EventHub::Subscription::next(
    std::chrono::milliseconds patience) {
  std::unique_lock lock(hub_.mutex_);
  hub_.news_.wait_for(lock, patience, [&] { return hub_.closed_ || hub_.has_news(seen_); });
  if (hub_.closed_) return {};
  std::vector<Event> events;
  for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
    const Latest& latest = hub_.latest_[kind];
    if (latest.number <= seen_[kind]) continue;
    seen_[kind] = latest.number;
    events.emplace_back(static_cast<EventKind>(kind), latest.text);
  }
  return events;
}

}  // namespace somato::live
