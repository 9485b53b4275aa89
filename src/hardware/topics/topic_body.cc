#include "hardware/topics/topic_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "recordings/explorations/nanoseconds.h"
#include "somato/core/check.h"

namespace somato::topics {
namespace {

constexpr double kWait = 0.05;  // s, between two looks whether the body is to stop
constexpr double kNanoseconds = 1e-9;
constexpr double kOnItsWay = 1.0;  // s, of a message that was sent before the exploration began
constexpr double kGap = 3.0;       // times the usual interval
constexpr std::size_t kMostIntervals = std::size_t{1} << 16;  // half a megabyte

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Matrix<float> row_of(const std::vector<float>& values) {
  return {1, values.size(), values};
}

Error went_back(const std::string& topic, double seconds) {
  return {ErrorKind::kData, fmt::format("the clock of the server went back by {:.3f} s", seconds),
          topic, "begin again when the clock of the robot is set"};
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
                                                    double patience, KeptFrames keep) {
  require(!sensors.empty(), "a body of topics has at least one sensor");
  std::unique_ptr<TopicBody> body(new TopicBody(std::move(name), client, patience, keep));
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
    const TopicEncoding encoding{topic.type, topic.encoding, topic.definition_encoding,
                                 topic.definition};
    auto messages = compile_topic_messages(encoding);
    if (!messages) return fail(with_topic(std::move(messages.error()), sensor.topic));
    auto reader = ChannelReader::compile(messages->type, sensor.paths, sensor.names);
    if (!reader) return fail(with_topic(std::move(reader.error()), sensor.topic));
    ElementOrder order = reader->order();
    sensors_.push_back({std::move(sensor),
                        index,
                        std::move(*messages),
                        std::move(*reader),
                        std::move(order),
                        false,
                        {},
                        false});
  }
  description_.sensors.resize(sensors_.size());
  state_.readings.resize(sensors_.size());
  if (keep_ == KeptFrames::kEvery) state_.times.resize(sensors_.size());
  return {};
}

// The first frame of a sensor determines its number of elements.
Result<void> TopicBody::wait_for_all() {
  const double until = now() + patience_;
  for (;;) {
    const auto missing = std::find_if(sensors_.begin(), sensors_.end(),
                                      [](const Sensor& sensor) { return !sensor.is_known; });
    if (missing == sensors_.end()) return {};
    if (now() >= until) return fail(silent(*missing));
    for (const Arrival& arrival : client_.take(kWait)) {
      for (std::size_t i = 0; i < sensors_.size(); ++i) {
        if (sensors_[i].topic != arrival.topic) continue;
        SOMATO_TRY(const bool is_frame, take_values(i, arrival));
        if (!is_frame) continue;
        state_.readings[i] = row_of(sensors_[i].latest);
        if (!sensors_[i].is_known) SOMATO_TRY_VOID(describe(i, arrival));
      }
    }
  }
}

Result<void> TopicBody::describe(std::size_t index, const Arrival& arrival) {
  Sensor& sensor = sensors_[index];
  const TopicSensor& declared = sensor.declared;
  std::string cdr;
  auto shape = sensor.messages.in_cdr(arrival.payload, cdr).and_then([&](std::string_view message) {
    return sensor.reader.shape(message);
  });
  if (!shape) return fail(with_topic(std::move(shape.error()), declared.topic));
  description_.sensors[index] = {declared.name,     declared.unit, sensor.order.names(),
                                 std::move(*shape), 0.0,           true};
  sensor.is_known = true;
  return {};
}

void TopicBody::begin() {
  client_.take(0.0);
  arrivals_.clear();
  intervals_.clear();
  later_ = 0;
  longest_later_ = 0.0;
  gaps_later_ = 0;
  left_out_ = 0;
  first_time_.reset();
  state_.time = 0.0;
  clear_frames();
}

// The values remain where only the latest ones are kept.
void TopicBody::clear_frames() {
  if (keep_ == KeptFrames::kLatest) return;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    state_.readings[i] = Matrix<float>(0, sensors_[i].latest.size());
    state_.times[i].clear();
  }
}

TopicTimes TopicBody::times() const {
  TopicTimes times;
  times.left_out = left_out_;
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
  clear_frames();
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

// Whether it is a frame of the first topic.
Result<bool> TopicBody::take(const Arrival& arrival) {
  bool is_frame = false;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    if (sensors_[i].topic != arrival.topic) continue;
    SOMATO_TRY(sensors_[i].is_new, take_values(i, arrival));
    is_frame = is_frame || sensors_[i].is_new;
  }
  is_frame = is_frame && arrival.topic == 0;
  if (is_frame) SOMATO_TRY_VOID(keep_time(arrival.time));
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    if (std::exchange(sensors_[i].is_new, false)) SOMATO_TRY_VOID(add_frame(i, arrival.time));
  }
  return is_frame;
}

// A message that was on its way when the exploration began belongs to none.
Result<void> TopicBody::add_frame(std::size_t index, std::uint64_t time) {
  const Sensor& sensor = sensors_[index];
  if (keep_ == KeptFrames::kLatest) {
    state_.readings[index] = row_of(sensor.latest);
    return {};
  }
  if (!first_time_) return {};
  const double seconds = seconds_of(time);
  if (seconds < -kOnItsWay) return fail(went_back(sensor.declared.topic, -seconds));
  if (seconds < 0.0) return {};
  std::vector<double>& times = state_.times[index];
  if (!times.empty() && seconds < times.back()) {
    return fail(went_back(sensor.declared.topic, times.back() - seconds));
  }
  times.push_back(seconds);
  state_.readings[index].append(row_of(sensor.latest));
  return {};
}

double TopicBody::seconds_of(std::uint64_t time) const {
  const auto passed =
      static_cast<double>(std::max(time, *first_time_) - std::min(time, *first_time_));
  return (time < *first_time_ ? -passed : passed) * kNanoseconds;
}

// Whether the message has the elements of the sensor; otherwise it keeps its latest values.
Result<bool> TopicBody::take_values(std::size_t index, const Arrival& arrival) {
  Sensor& sensor = sensors_[index];
  std::string cdr;
  auto read = sensor.messages.in_cdr(arrival.payload, cdr).and_then([&](std::string_view message) {
    return sensor.reader.read(message, sensor.order, values_);
  });
  if (!read) return fail(with_topic(std::move(read.error()), sensor.declared.topic));
  if (values_.empty()) ++left_out_;
  if (values_.empty()) return false;
  const std::size_t before = sensor.latest.size();
  if (before != 0 && before != values_.size()) {
    return fail(
        ErrorKind::kData,
        fmt::format("a message has {} values, the first one had {}", values_.size(), before),
        sensor.declared.topic, "record it with 'ros2 bag record' and look at it");
  }
  const auto infinite =
      std::find_if(values_.begin(), values_.end(), [](double value) { return std::isinf(value); });
  if (infinite != values_.end()) {
    return fail(ErrorKind::kData,
                fmt::format("element {} of a message is infinite", infinite - values_.begin() + 1),
                sensor.declared.topic, "select elements that are finite");
  }
  sensor.latest.assign(values_.begin(), values_.end());
  return true;
}

Result<void> TopicBody::keep_time(std::uint64_t time) {
  if (!first_time_) {
    first_time_ = time;
  } else if (is_of_epoch(static_cast<std::int64_t>(time)) !=
             is_of_epoch(static_cast<std::int64_t>(*first_time_))) {
    return fail(ErrorKind::kData,
                fmt::format("the clock of the server jumped from {} to {}",
                            words_of_time(static_cast<std::int64_t>(last_time_)),
                            words_of_time(static_cast<std::int64_t>(time))),
                topics_.front(), "begin again when the clock of the robot is set");
  } else if (time < last_time_) {
    return fail(went_back(topics_.front(), static_cast<double>(last_time_ - time) * kNanoseconds));
  } else {
    keep_interval(static_cast<double>(time - last_time_) * kNanoseconds);
  }
  last_time_ = time;
  state_.time = seconds_of(time);
  return {};
}

Error TopicBody::silent(const std::string& topic) const {
  const TopicState state = client_.state();
  std::string what = fmt::format("no message arrived for {:g} s", patience_);
  if (!state.connected) what += "; the connection is lost: " + state.problem;
  return {ErrorKind::kSystem, what, topic, "check that the robot publishes it"};
}

Error TopicBody::silent(const Sensor& sensor) const {
  Error error = silent(sensor.declared.topic);
  const std::vector<std::string> known = sensor.order.known_names();
  if (known.empty()) return error;
  error.what = fmt::format("no message with all of the elements {} arrived for {:g} s",
                           fmt::join(sensor.order.names(), ", "), patience_);
  error.advice = fmt::format("its messages have the elements {}", fmt::join(known, ", "));
  return error;
}

}  // namespace somato::topics
