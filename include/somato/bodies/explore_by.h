#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "somato/bodies/body.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// Waiting times of a movement. Neither number is given in the papers.
struct Motion {
  double settle = 0.3;    ///< Seconds to come to rest after arrival; above 0.
  double longest = 20.0;  ///< Maximum seconds until arrival.
};

/// The positions of the grasps of an object: nine grasps at two heights and five wrist angles
/// (P06). Which nine of the ten, and in which order, is not given in the paper.
struct ExplorationPlan {
  std::vector<double> heights{126.0, 148.0};                        ///< mm.
  std::vector<double> wrist_angles{-48.0, -24.0, 0.0, 24.0, 48.0};  ///< deg.
  std::size_t grasps = 9;

  static const Declarations<ExplorationPlan>& declarations();
};

/// How a hand closes around an object guided by touch (P06). None of the numbers is given in the
/// paper.
struct GuardedGrasp {
  double iteration = 0.1;      ///< Duration of a step of all fingers, s.
  double proximal_step = 1.5;  ///< deg per iteration.
  double distal_step = 4.0;    ///< deg per iteration.
  double threshold = 1.0;      ///< Summed change of a segment's taxels, in their unit.
  std::size_t still_iterations = 3;
  std::size_t most_iterations = 200;
  double proximal_open = 0.0;  ///< deg.
  double distal_open = -75.0;  ///< deg.
  Motion motion;               ///< Between grasps.

  static const Declarations<GuardedGrasp>& declarations();
};

/// Called when a grasp (counting from 0) has closed, before the hand opens.
using AfterGrasp = std::function<Result<void>(std::size_t grasp)>;

/// Explores by grasping from each pose of the plan: the fingers open, the servos `height` (mm) and
/// `wrist` (deg) go there, the hand grasps, and opens again. The channels are the body's sensors
/// with only the frames of the grasps' iterations, at the times of the body's clock; there are no
/// labels. Errors: those of the parts and of `after_grasp`, naming the grasp; kData if no segment
/// of any grasp was stopped by touch: the hand never touched the object.
Result<Exploration> explore_by_grasping(Body& body, const ExplorationPlan& plan,
                                        const GuardedGrasp& grasp,
                                        const AfterGrasp& after_grasp = {});

/// How a whole hand closes until its fingers rest on an object, like LUCS Haptic Hand III (P11).
/// None of the numbers is given in the paper.
struct Closing {
  double iteration = 0.1;  ///< Seconds between frames.
  double share = 1.0;      ///< Share of each servo's maximum speed.
  double still = 1.0;      ///< deg; maximum movement of a joint while the hand is still.
  std::size_t still_iterations = 5;
  double longest = 10.0;  ///< Seconds.
  Motion motion;          ///< Before closing.

  static const Declarations<Closing>& declarations();
};

/// Explores by closing the hand once: all servos except `wrist` and `height` move to their minimum,
/// the open hand; then, at the declared share of their speed, towards their maximum, until the
/// driver has moved all of them there, whether or not an object stops them, and the elements of the
/// sensor `joints` have moved from the open hand and then remained within `still` deg for the still
/// iterations. The channels are the body's sensors with the frames of the closing, at the times of
/// the body's clock; there are no labels. Errors: kData if it takes longer than the maximum time
/// ("never closed"), or if `joints` gives no frame; kUsage for a body without a sensor `joints` or
/// without fingers; kSystem or kData as the body's commands and steps give them.
Result<Exploration> explore_by_closing(Body& body, const Closing& closing);

/// How a texture probe strokes: P11 section IV-A turns its lever by 36 degrees in 1 s.
struct StrokeParameters {
  double from = 0.0;
  double to = 36.0;
  double settle = 0.2;
  double step = 0.1;

  static const Declarations<StrokeParameters>& declarations();
};

/// Moves the body's `lever` to the start of the stroke, waits for rest, then strokes at maximum
/// speed and records `sound` in the meantime: the number of frames that its rate gives in that
/// time, none before or after. This is the only channel; labels are added by the caller.
///
/// Errors: kUsage for a body without that degree of freedom or sensor, parameters out of range and
/// a stroke shorter than a frame; kData for a start or end beyond the lever's limits, a sensor
/// without a rate or with too few frames and a lever that does not arrive; those of the body.
Result<Exploration> explore_by_stroking(Body& body, const StrokeParameters& parameters = {});

/// How a hardness probe presses: P11 section IV presses and reads the potentiometer at the end.
struct PressParameters {
  std::optional<double> to;
  double step = 0.05;
  std::size_t readings = 10;
  double patience = 20.0;

  static const Declarations<PressParameters>& declarations();
};

/// Moves the body's `stick` forward, waits until it is at rest, and records the `potentiometer`
/// once: one channel with one frame; labels are added by the caller.
///
/// It is at rest if the driver has finished and, for as many consecutive readings as a mean has,
/// the mean of the last readings differs from that of the same number before by at most three
/// standard errors, estimated from the differences of consecutive readings, plus one count. A stick
/// at the end of its stroke is also at rest.
///
/// Errors: kUsage for a body without that degree of freedom or sensor and parameters out of range;
/// kData for a target beyond the stick's limits and a stick that does not come to rest in the
/// maximum time; those of the body. The observer of the body receives every reading as recorded,
/// although only the last one belongs to the exploration.
Result<Exploration> explore_by_pressing(Body& body, const PressParameters& parameters = {});

/// Records a body at rest, or one that others move, for `duration` s of its time: the channels are
/// its sensors with a frame after each step of `step` s; labels are added by the caller. Errors:
/// those of the body. Throws InvalidArgument unless `step` is above 0.
Result<Exploration> explore_by_holding(Body& body, double duration, double step);

}  // namespace somato
