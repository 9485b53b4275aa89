#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bodies/body/kept_frames.h"
#include "hardware/topics/topic_client.h"
#include "recordings/explorations/element_order.h"
#include "recordings/ros/channel_reader.h"
#include "recordings/ros/topic_type.h"
#include "somato/bodies/body.h"

namespace somato::topics {

/// A sensor of which a topic reports.
struct TopicSensor {
  std::string name;                ///< The name of the channel, such as "touch".
  std::string unit;                ///< Empty: none, or not known.
  std::string topic;               ///< Such as "/xServTopic".
  std::vector<std::string> paths;  ///< Its numbers in a message; see FieldReader.
  std::string names;               ///< The path of the names of its elements, or empty.
};

/// The intervals between the messages of the first topic of a body, since it began.
struct TopicTimes {
  std::size_t messages = 0;
  double usual = 0.0;        ///< The median interval in s.
  double longest = 0.0;      ///< The longest interval in s.
  std::size_t gaps = 0;      ///< Intervals of more than three times the usual one.
  std::size_t left_out = 0;  ///< Messages without the elements of a sensor.
};

/// A body without servos, whose sensors are topics of a robot. Its time is that of the server's
/// clock, from the first message of the first topic since it began.
///
/// A step ends with the next message of the first topic, however long that takes: every message of
/// it is a frame, with its time. The other sensors have the values of their last message, or, if
/// every message is kept, a frame for each message since the step before, with its time. A number
/// that a message lacks is NaN.
class TopicBody : public Body {
 public:
  /// Subscribes to the topics and waits at most `patience` seconds for them and for a message of
  /// each; `client` must outlive the body. Errors (kSystem): no connection, or a topic that is
  /// silent; (kUsage): an unknown topic or path; (kData): a message that cannot be read. Throws
  /// InvalidArgument for no sensors.
  static Result<std::unique_ptr<TopicBody>> start(std::string name, TopicClient& client,
                                                  std::vector<TopicSensor> sensors, double patience,
                                                  KeptFrames keep = KeptFrames::kLatest);

  const BodyDescription& description() const override { return description_; }
  const BodyState& state() const override { return state_; }

  /// Begins another exploration: what has arrived in the meantime is discarded, and time is 0
  /// again with the next message.
  void begin();

  /// The intervals since begin().
  TopicTimes times() const;

 protected:
  Result<void> drive_to(std::span<const double> targets) override;

  /// Errors (kSystem): no message of the first topic for `patience` seconds; (kData): a message
  /// that cannot be read, has other elements than the first one (see ElementOrder), or is older
  /// than the one before. Messages without the elements that a sensor selects by name are counted.
  Result<void> pass(double seconds) override;

 private:
  struct Sensor {
    TopicSensor declared;
    std::size_t topic = 0;
    TopicMessages messages;
    ChannelReader reader;
    ElementOrder order;
    bool is_known = false;      ///< Whether it is described.
    std::vector<float> latest;  ///< The values of its latest message.
    bool is_new = false;        ///< Whether they are those of the message that is being taken.
  };

  TopicBody(std::string name, TopicClient& client, double patience, KeptFrames keep)
      : client_(client), patience_(patience), keep_(keep) {
    description_.name = std::move(name);
  }

  Result<void> subscribe(std::vector<TopicSensor> sensors);
  Result<void> wait_for_all();
  Result<bool> take(const Arrival& arrival);
  Result<bool> take_values(std::size_t sensor, const Arrival& arrival);
  Result<void> describe(std::size_t sensor, const Arrival& arrival);
  Result<void> keep_time(std::uint64_t time);
  Result<void> add_frame(std::size_t sensor, std::uint64_t time);
  void clear_frames();
  double seconds_of(std::uint64_t time) const;
  Result<Arrival> next();
  void keep_interval(double seconds);
  Error silent(const std::string& topic) const;
  Error silent(const Sensor& sensor) const;

  TopicClient& client_;
  double patience_;
  KeptFrames keep_;
  BodyDescription description_;
  BodyState state_;
  std::vector<std::string> topics_;
  std::vector<Sensor> sensors_;
  std::deque<Arrival> arrivals_;
  std::vector<double> values_;
  std::optional<std::uint64_t> first_time_;
  std::uint64_t last_time_ = 0;
  std::vector<double> intervals_;  // the first ones, which show the usual interval
  double usual_ = 0.0;             // of these
  std::size_t later_ = 0;          // intervals after them
  double longest_later_ = 0.0;
  std::size_t gaps_later_ = 0;
  std::size_t left_out_ = 0;
};

}  // namespace somato::topics
