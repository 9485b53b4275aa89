#include "bodies/body/guarded_grasp.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "bodies/body/motion.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// The readings of the taxels at the end of the last step; empty if there were none during it.
std::span<const float> last_frame(const Body& body, std::size_t sensor) {
  const Matrix<float>& frames = body.state().readings.at(sensor);
  if (frames.rows() == 0) return {};
  return frames.row(frames.rows() - 1);
}

// A closing segment: its step, its limit, and the readings at its start.
class ClosingSegment {
 public:
  ClosingSegment(const Segment& segment, double step, double closed)
      : segment_(&segment), step_(step), closed_(closed) {}

  void start(std::span<const float> touch) { baseline_.assign(touch.begin(), touch.end()); }

  void advance(std::vector<double>& targets) const {
    double& target = targets[segment_->servo];
    target = std::min(target + step_, closed_);
  }

  bool touches(std::span<const float> touch, double threshold) const {
    double change = 0.0;
    for (const std::size_t taxel : segment_->taxels) {
      change += std::abs(static_cast<double>(touch[taxel]) - static_cast<double>(baseline_[taxel]));
    }
    return change > threshold;
  }

  bool closed(const std::vector<double>& targets, const BodyState& state) const {
    return targets[segment_->servo] >= closed_ &&
           has_arrived(state.positions[segment_->servo], closed_);
  }

  // A servo that lags behind stays where it is, too.
  void hold(std::vector<double>& targets, const Body& body) const {
    double& target = targets[segment_->servo];
    const double present = present_targets(body)[segment_->servo];
    if (!has_arrived(present, target)) target = present;
  }

 private:
  const Segment* segment_;
  double step_;
  double closed_;
  std::vector<float> baseline_;
};

// A finger: its proximal segment, then its distal one.
class ClosingFinger {
 public:
  ClosingFinger(const Finger& finger, const GuardedGrasp& grasp, const BodyDescription& body)
      : name_(&finger.name),
        segments_{ClosingSegment(finger.proximal, grasp.proximal_step,
                                 body.degrees_of_freedom[finger.proximal.servo].most),
                  ClosingSegment(finger.distal, grasp.distal_step,
                                 body.degrees_of_freedom[finger.distal.servo].most)} {}

  const std::string& name() const { return *name_; }
  bool done() const { return current_ == segments_.size(); }

  void start(std::span<const float> touch) { segments_[0].start(touch); }

  void advance(std::vector<double>& targets) const {
    if (!done()) segments_[current_].advance(targets);
  }

  // Whether the moving segment was just stopped by touch.
  bool feel(std::span<const float> touch, double threshold, const Body& body,
            std::vector<double>& targets) {
    if (done()) return false;
    const ClosingSegment& segment = segments_[current_];
    const bool touches = segment.touches(touch, threshold);
    if (!touches && !segment.closed(targets, body.state())) return false;
    segment.hold(targets, body);
    if (++current_ < segments_.size()) segments_[current_].start(touch);
    return touches;
  }

 private:
  const std::string* name_;
  std::array<ClosingSegment, 2> segments_;
  std::size_t current_ = 0;
};

class GuardedHand {
 public:
  GuardedHand(Body& body, const HandLayout& hand, const GuardedGrasp& grasp)
      : body_(body), touch_(hand.touch), grasp_(grasp) {
    fingers_.reserve(hand.fingers.size());
    for (const Finger& finger : hand.fingers) {
      fingers_.emplace_back(finger, grasp, body.description());
    }
  }

  Result<GraspResult> close(std::vector<double>& targets, FrameLog& log) {
    SOMATO_TRY_VOID(feel_first());
    GraspResult result;
    std::size_t still = 0;
    while (still < grasp_.still_iterations || !done()) {
      if (result.iterations == grasp_.most_iterations) return never_closed();
      still += done() ? 1 : 0;
      SOMATO_TRY_VOID(iterate(targets, log));
      ++result.iterations;
      for (ClosingFinger& finger : fingers_) {
        result.touching += finger.feel(felt_, grasp_.threshold, body_, targets) ? 1 : 0;
      }
    }
    return result;
  }

 private:
  bool done() const {
    return std::all_of(fingers_.begin(), fingers_.end(),
                       [](const ClosingFinger& finger) { return finger.done(); });
  }

  Result<void> feel_first() {
    if (body_.state().readings.size() <= touch_) {
      return fail(ErrorKind::kData, "the body has no touch reading yet", "touch",
                  "wait until it has settled");
    }
    SOMATO_TRY_VOID(feel());
    if (felt_.empty()) {
      return fail(ErrorKind::kData, "the sensor 'touch' gave no frame before the grasp", "touch",
                  "set a settling time longer than the sensor's frame");
    }
    for (ClosingFinger& finger : fingers_) finger.start(felt_);
    return {};
  }

  Result<void> feel() {
    const std::span<const float> frame = last_frame(body_, touch_);
    const std::size_t taxels = body_.description().sensors[touch_].element_names.size();
    if (!frame.empty() && frame.size() != taxels) {
      return fail(ErrorKind::kData,
                  fmt::format("the sensor 'touch' gave {} elements, not {}", frame.size(), taxels),
                  "touch", "check the body's description");
    }
    if (!frame.empty()) felt_.assign(frame.begin(), frame.end());
    return {};
  }

  Result<void> iterate(std::vector<double>& targets, FrameLog& log) {
    for (const ClosingFinger& finger : fingers_) finger.advance(targets);
    return body_.command(targets)
        .and_then([&] { return body_.step(grasp_.iteration, Readings::kRecorded); })
        .and_then([&] { return log.append(body_.state()); })
        .and_then([&] { return feel(); });
  }

  tl::unexpected<Error> never_closed() const {
    std::vector<std::string> open;
    for (const ClosingFinger& finger : fingers_) {
      if (!finger.done()) open.push_back(finger.name());
    }
    return fail(ErrorKind::kData,
                fmt::format("the hand never closed: after {} iterations {}", grasp_.most_iterations,
                            open.empty() ? "it was not at rest"
                                         : fmt::format("{} still moved", fmt::join(open, ", "))),
                {}, "raise 'most_iterations' or the steps");
  }

  Body& body_;
  std::size_t touch_;
  const GuardedGrasp& grasp_;
  std::vector<ClosingFinger> fingers_;
  std::vector<float> felt_;
};

}  // namespace

const Declarations<GuardedGrasp>& GuardedGrasp::declarations() {
  using P = GuardedGrasp;
  static const auto declared =
      Declarations<P>()
          .add("iteration", &P::iteration, "s", Range::between(1e-4, 10),
               "Time for one step of all fingers; touch is evaluated after each step. Not given "
               "in the paper.")
          .add("proximal_step", &P::proximal_step, "deg", Range::between(1e-4, 180),
               "Angle of a proximal segment per step. Not given in the paper.")
          .add("distal_step", &P::distal_step, "deg", Range::between(1e-4, 180),
               "Angle of a distal segment per step. Not given in the paper.")
          .add("threshold", &P::threshold, "N", Range::between(0, 1e6),
               "A segment stops when the summed change of its taxels exceeds this value. Not given "
               "in the "
               "paper.")
          .add("still_iterations", &P::still_iterations, "", Range::between(0, 1e6),
               "Number of iterations with the closed hand at the end of a grasp. Not given in the "
               "paper.")
          .add("most_iterations", &P::most_iterations, "", Range::between(1, 1e6),
               "Maximum number of iterations of a grasp. Not given in the paper.")
          .add("proximal_open", &P::proximal_open, "deg", Range::between(-360, 360),
               "Position of the proximal segments in the open hand. Not given in the paper.")
          .add("distal_open", &P::distal_open, "deg", Range::between(-360, 360),
               "Position of the distal segments in the open hand. Not given in the paper.")
          .add(
              "settle", [](P& p) -> auto& { return p.motion.settle; }, "s",
              Range::between(1e-4, 60),
              "Time to come to rest after a move between grasps. Not given in the paper.")
          .add(
              "longest_move", [](P& p) -> auto& { return p.motion.longest; }, "s",
              Range::between(1e-3, 3600),
              "Maximum time for a move between grasps. Not given in the paper.");
  return declared;
}

Result<GraspResult> guarded_grasp(Body& body, const HandLayout& hand, const GuardedGrasp& grasp,
                                  std::vector<double>& targets, FrameLog& log) {
  require(targets.size() == body.description().degrees_of_freedom.size(),
          "guarded_grasp: one target for each degree of freedom");
  return GuardedHand(body, hand, grasp).close(targets, log);
}

}  // namespace somato
