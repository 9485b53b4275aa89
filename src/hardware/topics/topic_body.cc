#include "hardware/topics/topic_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "recordings/ros/topic_type.h"
#include "somato/core/check.h"

namespace somato::topics {
namespace {

constexpr double kWait = 0.05;  // s, between two looks whether the body is to stop
constexpr double kNanoseconds = 1e-9;
constexpr double kGap = 3.0;                                  // times the usual interval
constexpr std::size_t kMostIntervals = std::size_t{1} << 16;  // half a megabyte

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Error with_topic(Error error, const std::string& topic) {
  error.where = error.where.empty() ? topic : topic + ": " + error.where;
  return error;
}

}  // namespace

Result<std::unique_ptr<TopicBody>> TopicBody::start(std::string name, TopicClient& client,
                                                    std::vector<TopicSensor> sensors,
                                                    double patience) {
  require(!sensors.empty(), "a body of topics has at least one sensor");
  std::unique_ptr<TopicBody> body(new TopicBody(std::move(name), client, patience));
  SOMATO_TRY_VOID(body->subscribe(std::move(sensors)));
  SOMATO_TRY_VOID(body->wait_for_all());
  return body;
}

Result<void> TopicBody::subscribe(std::vector<TopicSensor> sensors) {
  for (const TopicSensor& sensor : sensors) {
    if (std::find(topics_.begin(), topics_.end(), sensor.topic) == topics_.end()) {
      topics_.push_back(sensor.topic);
    }
  }
  SOMATO_TRY(const auto found, client_.subscribe(topics_, patience_));
  for (TopicSensor& sensor : sensors) {
    const auto place = std::find(topics_.begin(), topics_.end(), sensor.topic) - topics_.begin();
    const auto index = static_cast<std::size_t>(place);
    const Topic& topic = found[index];
    auto type = compile_topic_type(
        {topic.type, topic.encoding, topic.definition_encoding, topic.definition});
    if (!type) return fail(with_topic(std::move(type.error()), sensor.topic));
    auto reader = ChannelReader::compile(*type, sensor.paths, sensor.names);
    if (!reader) return fail(with_topic(std::move(reader.error()), sensor.topic));
    sensors_.push_back({std::move(sensor), index, std::move(*reader)});
  }
  description_.sensors.resize(sensors_.size());
  state_.readings.resize(sensors_.size());
  return {};
}

// The first message of a topic says how many elements its sensors have.
Result<void> TopicBody::wait_for_all() {
  std::vector<bool> known(topics_.size());
  const double until = now() + patience_;
  while (std::find(known.begin(), known.end(), false) != known.end()) {
    if (now() >= until) {
      const auto missing = std::find(known.begin(), known.end(), false) - known.begin();
      return fail(silent(topics_[static_cast<std::size_t>(missing)]));
    }
    for (const Arrival& arrival : client_.take(kWait)) {
      if (arrival.topic >= topics_.size() || known[arrival.topic]) continue;
      known[arrival.topic] = true;
      for (std::size_t i = 0; i < sensors_.size(); ++i) {
        if (sensors_[i].topic != arrival.topic) continue;
        const TopicSensor& declared = sensors_[i].declared;
        auto names = sensors_[i].reader.element_names(arrival.payload);
        if (!names) return fail(with_topic(std::move(names.error()), declared.topic));
        auto shape = sensors_[i].reader.shape(arrival.payload);
        if (!shape) return fail(with_topic(std::move(shape.error()), declared.topic));
        description_.sensors[i] = {declared.name,     declared.unit, std::move(*names),
                                   std::move(*shape), 0.0,           true};
        SOMATO_TRY_VOID(take_values(i, arrival));
      }
    }
  }
  return {};
}

void TopicBody::begin() {
  client_.take(0.0);
  arrivals_.clear();
  intervals_.clear();
  later_ = 0;
  longest_later_ = 0.0;
  gaps_later_ = 0;
  first_time_.reset();
  state_.time = 0.0;
}

TopicTimes TopicBody::times() const {
  TopicTimes times;
  if (!first_time_) return times;
  times.messages = intervals_.size() + later_ + 1;
  if (intervals_.empty()) return times;
  times.usual = median_of(intervals_);
  times.longest = std::max(longest_later_, *std::max_element(intervals_.begin(), intervals_.end()));
  times.gaps = gaps_later_ + static_cast<std::size_t>(std::count_if(
                                 intervals_.begin(), intervals_.end(),
                                 [&](double each) { return each > kGap * times.usual; }));
  return times;
}

// An exploration may last for weeks.
void TopicBody::keep_interval(double seconds) {
  if (intervals_.size() < kMostIntervals) {
    intervals_.push_back(seconds);
    return;
  }
  if (later_++ == 0) usual_ = median_of(intervals_);
  longest_later_ = std::max(longest_later_, seconds);
  if (seconds > kGap * usual_) ++gaps_later_;
}

Result<void> TopicBody::drive_to(std::span<const double> targets) {
  require(targets.empty(), "a body of topics has no servos");
  return {};
}

Result<void> TopicBody::pass(double /*seconds*/) {
  for (;;) {
    SOMATO_TRY(const auto arrival, next());
    SOMATO_TRY(const bool is_frame, take(arrival));
    if (is_frame) return {};
  }
}

// The next message of any topic.
Result<Arrival> TopicBody::next() {
  const double until = now() + patience_;
  while (arrivals_.empty()) {
    SOMATO_TRY_VOID(check_stop());
    if (now() >= until) return fail(silent(topics_.front()));
    arrivals_ = client_.take(kWait);
  }
  Arrival arrival = std::move(arrivals_.front());
  arrivals_.pop_front();
  return arrival;
}

// Whether it is a message of the first topic.
Result<bool> TopicBody::take(const Arrival& arrival) {
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    if (sensors_[i].topic == arrival.topic) SOMATO_TRY_VOID(take_values(i, arrival));
  }
  if (arrival.topic != 0) return false;
  SOMATO_TRY_VOID(keep_time(arrival.time));
  return true;
}

Result<void> TopicBody::take_values(std::size_t index, const Arrival& arrival) {
  const Sensor& sensor = sensors_[index];
  auto read = sensor.reader.read(arrival.payload, values_);
  if (!read) return fail(with_topic(std::move(read.error()), sensor.declared.topic));
  const std::size_t before = state_.readings[index].columns();
  if (before != 0 && before != values_.size()) {
    return fail(
        ErrorKind::kData,
        fmt::format("a message has {} values, the first one had {}", values_.size(), before),
        sensor.declared.topic, "record it with 'ros2 bag record' and look at it");
  }
  state_.readings[index] =
      Matrix<float>(1, values_.size(), std::vector<float>(values_.begin(), values_.end()));
  return {};
}

Result<void> TopicBody::keep_time(std::uint64_t time) {
  if (!first_time_) {
    first_time_ = time;
  } else if (time < last_time_) {
    return fail(ErrorKind::kData,
                fmt::format("the clock of the server went back by {:.3f} s",
                            static_cast<double>(last_time_ - time) * kNanoseconds),
                topics_.front(), "begin again when the clock of the robot is set");
  } else {
    keep_interval(static_cast<double>(time - last_time_) * kNanoseconds);
  }
  last_time_ = time;
  state_.time = static_cast<double>(time - *first_time_) * kNanoseconds;
  return {};
}

Error TopicBody::silent(const std::string& topic) const {
  const TopicState state = client_.state();
  std::string what = fmt::format("no message arrived for {:g} s", patience_);
  if (!state.connected) what += "; the connection is lost: " + state.problem;
  return {ErrorKind::kSystem, what, topic, "check that the robot publishes it"};
}

}  // namespace somato::topics
