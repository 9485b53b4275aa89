
#include "somato/bodies/explore_by.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "bodies/body/driving.h"
#include "recordings/explorations/growing_channel.h"

namespace somato {
namespace {

// The mean of the given number of readings, ending `before` the last one.
double mean_of(const std::vector<float>& readings, std::size_t count, std::size_t before) {
  const auto last = readings.end() - static_cast<std::ptrdiff_t>(before);
  const auto first = last - static_cast<std::ptrdiff_t>(count);
  return std::accumulate(first, last, 0.0) / static_cast<double>(count);
}

// The variance of a single reading, by the scatter between neighbours among the last: a slow
// movement hardly counts.
double noise_variance(const std::vector<float>& readings, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = readings.size() - count + 1; i < readings.size(); ++i) {
    const double step = static_cast<double>(readings[i]) - static_cast<double>(readings[i - 1]);
    sum += 0.5 * step * step;
  }
  return sum / static_cast<double>(count - 1);
}

bool looks_at_rest(const std::vector<float>& readings, std::size_t count) {
  if (readings.size() < 2 * count) return false;
  const double change = mean_of(readings, count, 0) - mean_of(readings, count, count);
  const double error =
      std::sqrt(2.0 * noise_variance(readings, 2 * count) / static_cast<double>(count));
  return std::abs(change) <= 3.0 * error + 1.0;
}

Result<float> read_once(Body& body, std::size_t sensor, double seconds) {
  SOMATO_TRY_VOID(body.step(seconds, Readings::kRecorded));
  const Matrix<float>& reading = body.state().readings[sensor];
  if (!reading.empty()) return reading(reading.rows() - 1, 0);
  return fail(ErrorKind::kData, "'potentiometer' gave no reading", "potentiometer",
              "check the connection");
}

Result<void> wait_for_rest(Body& body, std::size_t stick, std::size_t sensor, double target,
                           const PressParameters& parameters) {
  std::vector<float> readings;
  std::size_t rests = 0;
  const double until = body.state().time + parameters.patience;
  while (body.state().time < until) {
    SOMATO_TRY(const auto reading, read_once(body, sensor, parameters.step));
    readings.push_back(reading);
    const bool still =
        detail::has_arrived(body, stick, target) && looks_at_rest(readings, parameters.readings);
    rests = still ? rests + 1 : 0;
    if (rests == parameters.readings) return {};
  }
  return fail(ErrorKind::kData,
              fmt::format("the stick does not come to rest within {:g} s", parameters.patience),
              body.description().degrees_of_freedom[stick].name,
              "raise 'patience', or check what moves it");
}

// The last frame of a sensor.
Exploration exploration_of(const ChannelDescription& sensor, const Matrix<float>& reading) {
  const auto last = reading.row(reading.rows() - 1);
  Channel channel = channel_of(sensor, Matrix<float>(0, last.size()));
  append_readings(channel, Matrix<float>(1, last.size(), {last.begin(), last.end()}));
  channel.rate = 0.0;
  Exploration exploration;
  exploration.channels.push_back(std::move(channel));
  return exploration;
}

}  // namespace

const Declarations<PressParameters>& PressParameters::declarations() {
  using P = PressParameters;
  static const Declarations<PressParameters> kAll =
      Declarations<PressParameters>()
          .add("to", &P::to, "mm", Range::between(-1e4, 1e4),
               "Target of the stick; automatic: its limit. Not given in the paper.")
          .add("step", &P::step, "s", Range::between(1e-4, 60),
               "Time between readings. Not given in the paper.")
          .add("readings", &P::readings, "", Range::between(2, 1e6),
               "Number of readings averaged to detect rest. Not given in the paper.")
          .add("patience", &P::patience, "s", Range::between(1e-3, 3600),
               "Maximum time to come to rest. Not given in the paper.");
  return kAll;
}

Result<Exploration> explore_by_pressing(Body& body, const PressParameters& parameters) {
  SOMATO_TRY_VOID(check_ranges(parameters));
  SOMATO_TRY(const auto stick, find_degree_of_freedom(body.description(), "stick"));
  SOMATO_TRY(const auto sensor, find_sensor(body.description(), "potentiometer"));
  const double target = parameters.to.value_or(body.description().degrees_of_freedom[stick].most);
  SOMATO_TRY_VOID(detail::drive_one(body, stick, target));
  SOMATO_TRY_VOID(wait_for_rest(body, stick, sensor, target, parameters));
  return exploration_of(body.description().sensors[sensor], body.state().readings[sensor]);
}

}  // namespace somato
