// The kernels of neuron_activity_kernels.h.

#include "base/kernels/neuron_activity_kernels.h"
#include "guard.h"

namespace somato::bench {
namespace {

static_assert(kKernels<kernels::ActivityTable> == 5, "count each of them");

constexpr std::size_t kBlocks = 15;
constexpr std::size_t kLanes = LaneMatrix<float>::kLanes;
constexpr unsigned kExponent = 10;

}  // namespace

void count_activity_kernels(const Counted& counted) {
  const auto& table = kernels::activity_table();
  AlignedVector<float> values = noise<float>(kBlocks * kLanes, 61);
  AlignedVector<double> terms(values.size());
  float largest = 0.0F;
  const Digest of_values = [&] { return digest_of(values); };
  counted(
      "activity.similarities", [&] { table.similarities(values.data(), kBlocks, 0.25); },
      of_values);
  counted(
      "activity.rectify", [&] { largest = table.rectify(values.data(), kBlocks); },
      [&] { return digest_of(values, digest_with(1, double{largest})); });
  counted(
      "activity.power_terms",
      [&] { table.power_terms(values.data(), kBlocks, double{largest}, kExponent, terms.data()); },
      [&] { return digest_of(terms); });
  counted(
      "activity.powers", [&] { table.powers(values.data(), kBlocks, double{largest}, kExponent); },
      of_values);
  counted("activity.divide", [&] { table.divide(values.data(), kBlocks, 3.0); }, of_values);
}

}  // namespace somato::bench
