#include "systems/signals/onset.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "somato/core/check.h"

namespace somato {
namespace {

constexpr double kMostFrames = 1 << 24;

double quantity_of(const Matrix<float>& frames, std::size_t frame, std::size_t element,
                   OnsetQuantity quantity) {
  const double value{frames(frame, element)};
  if (quantity == OnsetQuantity::kMagnitude) return std::fabs(value);
  if (quantity == OnsetQuantity::kChange) return std::fabs(value - double{frames(0, element)});
  return value;
}

double greatest_in_frame(const Matrix<float>& frames, std::size_t frame,
                         const OnsetParameters& parameters) {
  const bool any = parameters.element == 0;
  const std::size_t first = any ? 0 : parameters.element - 1;
  const std::size_t end = any ? frames.columns() : parameters.element;
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t element = first; element < end; ++element) {
    greatest = std::max(greatest, quantity_of(frames, frame, element, parameters.quantity));
  }
  return greatest;
}

std::string elements_text(const OnsetParameters& parameters) {
  if (parameters.element == 0) return "any element";
  return fmt::format("element {}", parameters.element);
}

Error no_onset(const Matrix<float>& frames, const OnsetParameters& parameters, double greatest) {
  const std::string seen =
      frames.empty() ? "there are no frames" : fmt::format("the maximum is {:.6g}", greatest);
  return {ErrorKind::kData,
          fmt::format("there is no onset: the {} of {} never reaches the threshold {:.6g}; {}",
                      choice_name(parameters.quantity), elements_text(parameters),
                      parameters.threshold, seen),
          {},
          "lower 'threshold', or leave the exploration out"};
}

Error beyond_frames(const Matrix<float>& frames, const OnsetParameters& parameters,
                    std::size_t onset) {
  return {ErrorKind::kData,
          fmt::format("the window of {} frames from {} before the onset in frame {} extends beyond "
                      "the {} frames of the exploration",
                      parameters.length, parameters.before, onset + 1, frames.rows()),
          {},
          "shorten it, or set beyond = \"hold\""};
}

bool reaches_beyond(const Matrix<float>& frames, const OnsetParameters& parameters,
                    std::size_t onset) {
  return parameters.before > onset ||
         parameters.length > frames.rows() - (onset - parameters.before);
}

}  // namespace

const std::vector<std::pair<OnsetQuantity, std::string>>& Choices<OnsetQuantity>::all() {
  static const std::vector<std::pair<OnsetQuantity, std::string>> kAll{
      {OnsetQuantity::kValue, "value"},
      {OnsetQuantity::kMagnitude, "magnitude"},
      {OnsetQuantity::kChange, "change"}};
  return kAll;
}

const std::vector<std::pair<BeyondFrames, std::string>>& Choices<BeyondFrames>::all() {
  static const std::vector<std::pair<BeyondFrames, std::string>> kAll{
      {BeyondFrames::kRefuse, "refuse"}, {BeyondFrames::kHold, "hold"}};
  return kAll;
}

const Declarations<OnsetParameters>& OnsetParameters::declarations() {
  using P = OnsetParameters;
  static const Declarations<P> kAll =
      Declarations<P>()
          .add(
              "element", &P::element, "", Range::at_least(0),
              "Element whose onset is detected, counted from 1; 0: the first onset of any element. "
              "Not given in the paper.")
          .add("quantity", &P::quantity, "", Range::any(),
               "Quantity compared with the threshold: the element's value, its magnitude, or its "
               "distance from its value in the first frame. Not given in the paper.")
          .add("threshold", &P::threshold, "unit of the frames", Range::any(),
               "The onset is the first frame whose quantity is at least this. Not given in the "
               "paper.")
          .add("before", &P::before, "frames", Range::between(0, kMostFrames),
               "Number of frames of the window before the onset. Not given in the paper.")
          .add("length", &P::length, "frames", Range::between(1, kMostFrames),
               "Number of frames of the window. Not given in the paper.")
          .add("beyond", &P::beyond, "", Range::any(),
               "Treatment of a window that extends beyond the frames: an error, or the "
               "first or last frame is repeated. Not given in the paper.");
  return kAll;
}

Result<std::size_t> find_onset(const Matrix<float>& frames, const OnsetParameters& parameters) {
  if (parameters.element > frames.columns()) {
    return fail(ErrorKind::kUsage,
                fmt::format("element {} of the onset does not exist: the frames have {}",
                            parameters.element, frames.columns()),
                {}, "elements are counted from 1; 'element' 0 means any");
  }
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t frame = 0; frame < frames.rows(); ++frame) {
    greatest = std::max(greatest, greatest_in_frame(frames, frame, parameters));
    if (greatest >= parameters.threshold) return frame;
  }
  return fail(no_onset(frames, parameters, greatest));
}

Result<Matrix<float>> window_at_onset(const Matrix<float>& frames,
                                      const OnsetParameters& parameters) {
  require(parameters.length > 0, "the window at an onset needs a frame");
  SOMATO_TRY(const std::size_t onset, find_onset(frames, parameters));
  if (parameters.beyond == BeyondFrames::kRefuse && reaches_beyond(frames, parameters, onset)) {
    return fail(beyond_frames(frames, parameters, onset));
  }
  Matrix<float> window(parameters.length, frames.columns());
  for (std::size_t i = 0; i < window.rows(); ++i) {
    const std::size_t place = onset + i;  // `before` frames too far on
    const std::size_t frame = place < parameters.before ? 0 : place - parameters.before;
    std::ranges::copy(frames.row(std::min(frame, frames.rows() - 1)), window.row(i).begin());
  }
  return window;
}

}  // namespace somato
