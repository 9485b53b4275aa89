#include "views/session/folded_signal.h"

#include <algorithm>

#include "somato/core/check.h"

namespace somato::live {

FoldedSignal fold_signal(const SignalView& signal, const std::vector<std::size_t>& shape,
                         std::size_t most) {
  require(most > 0, "a signal cannot be folded to nothing");
  FoldedSignal folded;
  std::size_t size = signal.size;  // of what is left of the axes
  std::size_t left_out = 0;
  for (; size > most && left_out + 1 < shape.size(); ++left_out) size /= shape[left_out];
  const std::size_t stretch = std::max<std::size_t>((size + most - 1) / most, 1);
  folded.folded = left_out > 0 || stretch > 1;
  folded.shape.assign(shape.begin() + static_cast<std::ptrdiff_t>(left_out), shape.end());
  if (stretch > 1) folded.shape = {(size + stretch - 1) / stretch};
  if (size == 0) return folded;
  folded.values.assign((size + stretch - 1) / stretch, 0.0F);
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    const std::size_t element = signal.sparse ? signal.indices[i] : i;
    folded.values[element % size / stretch] += signal.values[i];
  }
  return folded;
}

}  // namespace somato::live
