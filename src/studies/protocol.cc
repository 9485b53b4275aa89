#include "somato/studies/protocol.h"

#include <numeric>

#include "somato/core/check.h"

namespace somato {

const std::vector<std::pair<Protocol, std::string>>& Choices<Protocol>::all() {
  static const std::vector<std::pair<Protocol, std::string>> choices{
      {Protocol::kTrainIsTest, "train_is_test"}, {Protocol::kLeaveOneOut, "leave_one_out"}};
  return choices;
}

std::vector<Fold> folds(Protocol protocol, std::size_t samples) {
  require(samples >= (protocol == Protocol::kTrainIsTest ? 1U : 2U),
          "a protocol needs something to train on");
  std::vector<std::size_t> all(samples);
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (protocol == Protocol::kTrainIsTest) return {{all, all}};
  std::vector<Fold> folds;
  for (std::size_t left_out = 0; left_out < samples; ++left_out) {
    Fold fold{all, {left_out}};
    fold.training.erase(fold.training.begin() + static_cast<std::ptrdiff_t>(left_out));
    folds.push_back(std::move(fold));
  }
  return folds;
}

}  // namespace somato
