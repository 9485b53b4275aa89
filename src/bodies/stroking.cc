#include "somato/bodies/stroking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bodies/driving.h"

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
              fmt::format("the stroke ends at {:g} {}, beyond the limits of '{}', {:g} to {:g} {}",
                          to, lever.unit, lever.name, lever.least, lever.most, lever.unit),
              lever.name, "let it end within the limits");
}

Result<Stroke> plan_stroke(const BodyDescription& body, const StrokeParameters& parameters) {
  if (auto ranges = check_ranges(parameters); !ranges) return fail(ranges.error());
  const auto lever = find_degree_of_freedom(body, "lever");
  if (!lever) return fail(lever.error());
  if (auto within = check_end(body.degrees_of_freedom[*lever], parameters.to); !within) {
    return fail(within.error());
  }
  const auto sound = find_sensor(body, "sound");
  if (!sound) return fail(sound.error());
  const double rate = body.sensors[*sound].rate;
  if (!(rate > 0.0)) {
    return fail(ErrorKind::kData, "'sound' has no rate", "sound", "use a body that samples it");
  }
  const double seconds =
      std::abs(parameters.to - parameters.from) / body.degrees_of_freedom[*lever].fastest;
  const auto frames = static_cast<std::size_t>(std::llround(seconds * rate));
  if (frames > 0) return Stroke{*lever, *sound, seconds, frames};
  return fail(ErrorKind::kUsage, "the stroke is shorter than a frame of 'sound'", {},
              "move 'from' and 'to' further apart");
}

Result<void> check_arrival(const Body& body, std::size_t lever, double target) {
  if (detail::has_arrived(body, lever, target)) return {};
  const double position = body.state().positions[lever];
  const DegreeOfFreedom& servo = body.description().degrees_of_freedom[lever];
  return fail(ErrorKind::kData,
              fmt::format("the lever is at {:g} {} instead of {:g}", position, servo.unit, target),
              servo.name, "see whether something blocks it");
}

Result<void> go_to_start(Body& body, const Stroke& stroke, const StrokeParameters& parameters) {
  const double away = std::abs(body.state().positions[stroke.lever] - parameters.from);
  if (auto sent = detail::drive_one(body, stroke.lever, parameters.from); !sent) return sent;
  const double seconds = away / body.description().degrees_of_freedom[stroke.lever].fastest;
  if (auto passed = detail::let_pass(body, seconds + parameters.settle, parameters.step,
                                     []() -> Result<void> { return {}; });
      !passed) {
    return passed;
  }
  return check_arrival(body, stroke.lever, parameters.from);
}

// What is heard on the way to the end of the stroke.
Result<std::vector<float>> listen(Body& body, const Stroke& stroke,
                                  const StrokeParameters& parameters,
                                  const AfterFrames& after_frames) {
  if (auto sent = detail::drive_one(body, stroke.lever, parameters.to); !sent) {
    return fail(sent.error());
  }
  std::vector<float> heard;
  auto passed = detail::let_pass(body, stroke.seconds, parameters.step, [&]() -> Result<void> {
    const auto values = body.state().readings[stroke.sound].values();
    heard.insert(heard.end(), values.begin(), values.end());
    return after_frames ? after_frames(body.state()) : Result<void>();
  });
  if (!passed) return fail(passed.error());
  if (auto arrived = check_arrival(body, stroke.lever, parameters.to); !arrived) {
    return fail(arrived.error());
  }
  return heard;
}

}  // namespace

const Declarations<StrokeParameters>& StrokeParameters::declarations() {
  using P = StrokeParameters;
  static const Declarations<StrokeParameters> kAll =
      Declarations<StrokeParameters>()
          .add("from", &P::from, "deg", Range::between(-360, 360),
               "Where the stroke starts. Not given in the paper.")
          .add("to", &P::to, "deg", Range::between(-360, 360),
               "Where it ends; 36 degrees further in P11.")
          .add("settle", &P::settle, "s", Range::between(0.001, 60),
               "Pause before the stroke. Not given in the paper.")
          .add("step", &P::step, "s", Range::between(1e-4, 60),
               "How often the body is asked; changes no frame. Not given in the paper.");
  return kAll;
}

Result<Exploration> explore_by_stroking(Body& body, const StrokeParameters& parameters,
                                        const AfterFrames& after_frames) {
  const auto stroke = plan_stroke(body.description(), parameters);
  if (!stroke) return fail(stroke.error());
  if (auto ready = go_to_start(body, *stroke, parameters); !ready) return fail(ready.error());
  auto heard = listen(body, *stroke, parameters, after_frames);
  if (!heard) return fail(std::move(heard.error()));
  Channel channel = detail::empty_channel(body.description().sensors[stroke->sound]);
  const std::size_t elements = body.state().readings[stroke->sound].columns();
  if (heard->size() < stroke->frames * elements) {
    return fail(ErrorKind::kData,
                fmt::format("'sound' gave {} of the stroke's {} frames", heard->size() / elements,
                            stroke->frames),
                channel.name, "see whether the sensor keeps up with its rate");
  }
  heard->resize(stroke->frames * elements);
  channel.frames = Matrix<float>(stroke->frames, elements, std::move(*heard));
  Exploration exploration;
  exploration.channels.push_back(std::move(channel));
  return exploration;
}

}  // namespace somato
