
#include "somato/bodies/explore_by.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "bodies/body/frame_log.h"
#include "bodies/body/motion.h"

namespace somato {
namespace {

// The servos that make a hand's fingers.
std::vector<std::size_t> finger_servos(const BodyDescription& body) {
  std::vector<std::size_t> servos;
  for (std::size_t i = 0; i < body.degrees_of_freedom.size(); ++i) {
    const std::string& name = body.degrees_of_freedom[i].name;
    if (name != "wrist" && name != "height") servos.push_back(i);
  }
  return servos;
}

// Counts the frames for which no joint has moved, after it has moved at all.
class Stillness {
 public:
  Stillness(std::span<const float> open, double still)
      : place_(open.begin(), open.end()), still_(still) {}

  void see(std::span<const float> joints) {
    bool moves = false;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const double away = static_cast<double>(joints[i]) - static_cast<double>(place_[i]);
      moves = moves || !(std::abs(away) <= still_);
    }
    if (moves) place_.assign(joints.begin(), joints.end());
    frames_ = moves ? 0 : frames_ + 1;
    has_moved_ = has_moved_ || moves;
  }

  std::size_t frames() const { return has_moved_ ? frames_ : 0; }

 private:
  std::vector<float> place_;
  double still_;
  std::size_t frames_ = 0;
  bool has_moved_ = false;
};

class ClosingHand {
 public:
  ClosingHand(Body& body, const Closing& closing, std::size_t joints)
      : body_(body),
        closing_(closing),
        joints_(joints),
        fingers_(finger_servos(body.description())),
        targets_(present_targets(body)),
        log_(body.description(), body.limits().memory) {}

  Result<void> open() {
    if (fingers_.empty()) {
      return fail(ErrorKind::kUsage,
                  fmt::format("the body '{}' has no fingers", body_.description().name),
                  body_.description().name, "use a hand");
    }
    for (const std::size_t i : fingers_) targets_[i] = servo(i).least;
    return move_to(body_, targets_, closing_.motion);
  }

  Result<void> close() {
    SOMATO_TRY(auto first, joints());
    Stillness stillness(first, closing_.still);
    for (std::size_t i = 0; !is_driven() || stillness.frames() < closing_.still_iterations; ++i) {
      if (static_cast<double>(i) * closing_.iteration >= closing_.longest) return never_closed();
      SOMATO_TRY_VOID(iterate());
      SOMATO_TRY(auto now, joints());
      stillness.see(now);
    }
    return {};
  }

  Exploration explored() && { return {{}, {}, std::move(log_).channels()}; }

 private:
  const DegreeOfFreedom& servo(std::size_t i) const {
    return body_.description().degrees_of_freedom[i];
  }

  Result<void> iterate() {
    for (const std::size_t i : fingers_) {
      const double way = closing_.share * servo(i).fastest * closing_.iteration;
      targets_[i] = std::min(targets_[i] + way, servo(i).most);
    }
    return body_.command(targets_)
        .and_then([&] { return body_.step(closing_.iteration, Readings::kRecorded); })
        .and_then([&] { return log_.append(body_.state()); });
  }

  // Whether the driver has taken all servos to their limits: those that an object stops press on.
  bool is_driven() const {
    return std::all_of(fingers_.begin(), fingers_.end(), [&](std::size_t i) {
      return targets_[i] == servo(i).most && has_arrived(body_.state().positions[i], targets_[i]);
    });
  }

  // The last frame of the last step; as many elements as before, or log_ has refused them.
  Result<std::span<const float>> joints() {
    const Matrix<float>& frames = body_.state().readings.at(joints_);
    const bool fits = elements_ == 0 || frames.columns() == elements_;
    if (frames.rows() > 0 && fits) {
      elements_ = frames.columns();
      return frames.row(frames.rows() - 1);
    }
    return fail(ErrorKind::kData, "the sensor 'joints' gave no frame, or one of another size",
                "joints", "the sensor must sample in each iteration");
  }

  tl::unexpected<Error> never_closed() const {
    return fail(ErrorKind::kData,
                fmt::format("the hand never closed: its joints did not move and come to rest "
                            "within {:g} s",
                            closing_.longest),
                {}, "raise 'longest', 'share' or 'still'");
  }

  Body& body_;
  const Closing& closing_;
  std::size_t joints_;
  std::size_t elements_ = 0;
  std::vector<std::size_t> fingers_;
  std::vector<double> targets_;
  FrameLog log_;
};

}  // namespace

const Declarations<Closing>& Closing::declarations() {
  using P = Closing;
  static const auto declared =
      Declarations<P>()
          .add("iteration", &P::iteration, "s", Range::between(1e-4, 10),
               "Time between frames. Not given in the paper.")
          .add("share", &P::share, "", Range{0.0, 1.0, true},
               "Speed at which each servo closes, as a share of its maximum. Not given in the "
               "paper.")
          .add("still", &P::still, "deg", Range::between(0, 360),
               "Largest joint movement of a hand at rest. Not given in the paper.")
          .add("still_iterations", &P::still_iterations, "", Range::between(1, 1e6),
               "Number of iterations at rest after closing. Not given in the paper.")
          .add("longest", &P::longest, "s", Range::between(1e-3, 3600),
               "Maximum time for closing the hand. Not given in the paper.")
          .add(
              "settle", [](P& p) -> auto& { return p.motion.settle; }, "s",
              Range::between(1e-4, 60),
              "Time for the open hand to come to rest. Not given in the paper.")
          .add(
              "longest_move", [](P& p) -> auto& { return p.motion.longest; }, "s",
              Range::between(1e-3, 3600),
              "Maximum time for opening the hand. Not given in the paper.");
  return declared;
}

Result<Exploration> explore_by_closing(Body& body, const Closing& closing) {
  SOMATO_TRY(const auto joints, find_sensor(body.description(), "joints"));
  ClosingHand hand(body, closing, joints);
  auto closed = hand.open().and_then([&] { return hand.close(); });
  if (!closed) return fail(std::move(closed.error()));
  return std::move(hand).explored();
}

}  // namespace somato
