
#include "somato/bodies/explore_by.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bodies/body/driving.h"

namespace somato {
namespace {

// The lever and the sound of a body, and the stroke in numbers.
struct Stroke {
  std::size_t lever = 0;
  std::size_t sound = 0;
  double seconds = 0.0;
  std::size_t frames = 0;
};

// A stroke that could not end must not begin.
Result<void> check_end(const DegreeOfFreedom& lever, double to) {
  if (to >= lever.least && to <= lever.most) return {};
  return fail(ErrorKind::kData,
              fmt::format("the stroke ends at {:g} {}, outside the limits of '{}', {:g} to {:g} {}",
                          to, lever.unit, lever.name, lever.least, lever.most, lever.unit),
              lever.name, "choose an end within the limits");
}

Result<Stroke> plan_stroke(const BodyDescription& body, const StrokeParameters& parameters) {
  SOMATO_TRY_VOID(check_ranges(parameters));
  SOMATO_TRY(const auto lever, find_degree_of_freedom(body, "lever"));
  SOMATO_TRY_VOID(check_end(body.degrees_of_freedom[lever], parameters.to));
  SOMATO_TRY(const auto sound, find_sensor(body, "sound"));
  const double rate = body.sensors[sound].rate;
  if (!(rate > 0.0)) {
    return fail(ErrorKind::kData, "'sound' has no rate", "sound", "use a body that samples it");
  }
  const double seconds =
      std::abs(parameters.to - parameters.from) / body.degrees_of_freedom[lever].fastest;
  const auto frames = static_cast<std::size_t>(std::llround(seconds * rate));
  if (frames > 0) return Stroke{lever, sound, seconds, frames};
  return fail(ErrorKind::kUsage, "the stroke is shorter than a frame of 'sound'", {},
              "move 'from' and 'to' further apart");
}

Result<void> check_arrival(const Body& body, std::size_t lever, double target) {
  if (detail::has_arrived(body, lever, target)) return {};
  const double position = body.state().positions[lever];
  const DegreeOfFreedom& servo = body.description().degrees_of_freedom[lever];
  return fail(ErrorKind::kData,
              fmt::format("the lever is at {:g} {} instead of {:g}", position, servo.unit, target),
              servo.name, "check for an obstacle");
}

Result<void> go_to_start(Body& body, const Stroke& stroke, const StrokeParameters& parameters) {
  const double away = std::abs(body.state().positions[stroke.lever] - parameters.from);
  SOMATO_TRY_VOID(detail::drive_one(body, stroke.lever, parameters.from));
  const double seconds = away / body.description().degrees_of_freedom[stroke.lever].fastest;
  SOMATO_TRY_VOID(detail::let_pass(body, seconds + parameters.settle, parameters.step));
  return check_arrival(body, stroke.lever, parameters.from);
}

// The sound during the stroke.
Result<std::vector<float>> listen(Body& body, const Stroke& stroke,
                                  const StrokeParameters& parameters) {
  SOMATO_TRY_VOID(detail::drive_one(body, stroke.lever, parameters.to));
  std::vector<float> samples;
  auto passed = detail::let_pass(body, stroke.seconds, parameters.step, Readings::kRecorded, [&] {
    const auto values = body.state().readings[stroke.sound].values();
    samples.insert(samples.end(), values.begin(), values.end());
  });
  if (!passed) return fail(passed.error());
  SOMATO_TRY_VOID(check_arrival(body, stroke.lever, parameters.to));
  return samples;
}

}  // namespace

const Declarations<StrokeParameters>& StrokeParameters::declarations() {
  using P = StrokeParameters;
  static const Declarations<StrokeParameters> kAll =
      Declarations<StrokeParameters>()
          .add("from", &P::from, "deg", Range::between(-360, 360),
               "Start of the stroke. Not given in the paper.")
          .add("to", &P::to, "deg", Range::between(-360, 360),
               "End of the stroke; 36 degrees further in P11.")
          .add("settle", &P::settle, "s", Range::between(0.001, 60),
               "Pause before the stroke. Not given in the paper.")
          .add("step", &P::step, "s", Range::between(1e-4, 60),
               "Interval at which the body is polled; does not affect frames. Not given in the "
               "paper.");
  return kAll;
}

Result<Exploration> explore_by_stroking(Body& body, const StrokeParameters& parameters) {
  SOMATO_TRY(const auto stroke, plan_stroke(body.description(), parameters));
  SOMATO_TRY_VOID(go_to_start(body, stroke, parameters));
  SOMATO_TRY(auto samples, listen(body, stroke, parameters));
  Channel channel = detail::empty_channel(body.description().sensors[stroke.sound]);
  const std::size_t elements = body.state().readings[stroke.sound].columns();
  if (samples.size() < stroke.frames * elements) {
    return fail(ErrorKind::kData,
                fmt::format("'sound' gave {} of the stroke's {} frames", samples.size() / elements,
                            stroke.frames),
                channel.name, "check whether the sensor reaches its rate");
  }
  samples.resize(stroke.frames * elements);
  channel.frames = Matrix<float>(stroke.frames, elements, std::move(samples));
  Exploration exploration;
  exploration.channels.push_back(std::move(channel));
  return exploration;
}

}  // namespace somato
