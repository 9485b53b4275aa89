#include "systems/signals/resampling.h"

#include <algorithm>
#include <cmath>

#include "somato/core/check.h"

namespace somato {
namespace {

// Without a rounding at share 0 and where both are equal, so that kept frames keep their bits.
float between(float first, float second, double share) {
  return static_cast<float>(std::fma(share, double{second} - double{first}, double{first}));
}

// Point `point` of `points` is at the fraction `rest / gaps` between frame `frame` and the next
// one; computed with integers, so that the last point is exactly the last frame.
void write_point(const Matrix<float>& frames, std::size_t point, Matrix<float>& points) {
  const std::size_t gaps = points.rows() - 1;
  const std::size_t place = point * (frames.rows() - 1);
  const std::size_t frame = place / gaps;
  const std::size_t next = std::min(frame + 1, frames.rows() - 1);
  const double share = static_cast<double>(place % gaps) / static_cast<double>(gaps);
  for (std::size_t j = 0; j < frames.columns(); ++j) {
    points(point, j) = between(frames(frame, j), frames(next, j), share);
  }
}

}  // namespace

const Declarations<ResamplingParameters>& ResamplingParameters::declarations() {
  using P = ResamplingParameters;
  static const Declarations<P> kAll = Declarations<P>().add(
      "points", &P::points, "", Range::between(2, static_cast<double>(std::size_t{1} << 20)),
      "Number of frames of the result, from the first to the last. Not given in the paper.");
  return kAll;
}

Result<Matrix<float>> resampled(const Matrix<float>& frames,
                                const ResamplingParameters& parameters) {
  require(parameters.points >= 2, "a resampling needs at least 2 points");
  if (frames.rows() == 0) {
    return fail(ErrorKind::kData, "there are no frames to resample", {},
                "leave the exploration out, or repair it");
  }
  Matrix<float> points(parameters.points, frames.columns());
  for (std::size_t point = 0; point < points.rows(); ++point) write_point(frames, point, points);
  return points;
}

}  // namespace somato
