#include "systems/signals/change.h"

#include <utility>
#include <vector>

namespace somato {

Result<Signal> change_of(const Matrix<float>& frames) {
  if (frames.rows() == 0) {
    return fail(ErrorKind::kData, "the channel has no frames", {},
                "leave the exploration out, or repair it");
  }
  std::vector<float> change(frames.columns());
  for (std::size_t j = 0; j < change.size(); ++j) {
    change[j] = frames(frames.rows() - 1, j) - frames(0, j);
  }
  return Signal::dense(std::move(change));
}

}  // namespace somato
