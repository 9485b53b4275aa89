// The kernels of distance_kernels.h.

#include <array>
#include <vector>

#include "base/core/lanes.h"
#include "base/kernels/distance_kernels.h"
#include "guard.h"

namespace somato::bench {
namespace {

using kernels::kInputsTogether;

static_assert(kKernels<kernels::DistanceTable> == 4, "count each of them");

constexpr std::size_t kNeurons = 225;
constexpr std::size_t kColumns = 67;

}  // namespace

void count_distance_kernels(const Counted& counted) {
  const auto& table = kernels::distance_table();
  const LaneMatrix<float> map = noisy_map<float>(kNeurons, kColumns);
  const kernels::Lanes<const float> weights = kernels::lanes(map);
  std::vector<AlignedVector<float>> inputs;
  std::vector<AlignedVector<float>> scores;
  for (std::size_t i = 0; i < kInputsTogether; ++i) {
    inputs.push_back(noise<float>(kColumns, 51 + i));
    scores.emplace_back(map.padded_rows());
  }
  std::array<const float*, kInputsTogether> x{};
  std::array<float*, kInputsTogether> out{};
  for (std::size_t i = 0; i < kInputsTogether; ++i) {
    x[i] = inputs[i].data();
    out[i] = scores[i].data();
  }
  const auto count = [&](const std::string& name, auto kernel) {
    counted(
        name,
        [&] {
          kernel(weights, x.data(), kInputsTogether, out.data());
          kernel(weights, x.data(), 1, out.data());
        },
        [&] { return digest_of(scores[1], digest_of(scores[0])); });
  };
  count("distance.absolute", table.absolute);
  count("distance.greatest", table.greatest);
  count("distance.squares", table.squares);
  count("distance.products", table.products);
}

}  // namespace somato::bench
