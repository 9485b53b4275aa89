#include "maps/sample_products.h"

#include <algorithm>
#include <utility>

#include "core/product_kernels.h"
#include "somato/core/threads.h"

namespace somato {
namespace {

using kernels::kRowLanes;

constexpr std::size_t kStrip = 128;  // elements at a time: lines for them stay in the first cache

}  // namespace

SampleProducts::SampleProducts(std::shared_ptr<const Samples> samples, std::size_t threads)
    : samples_(std::move(samples)), products_(samples_->count(), samples_->count()) {
  if (samples_->is_sparse()) columns_ = SampleColumns(*samples_);
  const std::size_t blocks = (samples_->count() + kRowLanes - 1) / kRowLanes;
  for_each_range(blocks, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) multiply(block);
  });
}

// Sixteen samples in the place of neurons.
void SampleProducts::multiply(std::size_t block) {
  const std::size_t first = block * kRowLanes;
  AlignedVector<double> lines(samples_->count() * kRowLanes);
  if (samples_->is_sparse()) {
    multiply_sparse(first, lines);
  } else {
    multiply_dense(first, lines);
  }
  const std::size_t count = std::min(kRowLanes, samples_->count() - first);
  for (std::size_t s = 0; s < samples_->count(); ++s) {
    for (std::size_t lane = 0; lane < count; ++lane) {
      products_(first + lane, s) = lines[s * kRowLanes + lane];
    }
  }
}

void SampleProducts::multiply_dense(std::size_t first_sample, AlignedVector<double>& out) const {
  const std::size_t samples = samples_->count();
  const std::size_t lanes = std::min(kRowLanes, samples - first_sample);
  AlignedVector<double> x(kStrip * samples);
  AlignedVector<double> w(kStrip * kRowLanes);
  for (std::size_t first = 0; first < samples_->size(); first += kStrip) {
    const std::size_t count = std::min(kStrip, samples_->size() - first);
    write_elements(first, count, x);
    for (std::size_t e = 0; e < count; ++e) {
      std::copy_n(&x[e * samples + first_sample], lanes, &w[e * kRowLanes]);
    }
    kernels::product_table().add_products(w.data(), x.data(), count, samples, out.data(),
                                          kRowLanes);
  }
}

void SampleProducts::multiply_sparse(std::size_t first_sample, AlignedVector<double>& out) const {
  AlignedVector<double> w(kStrip * kRowLanes);
  const auto starts = columns_.starts();
  for (std::size_t first = 0; first < columns_.elements().size(); first += kStrip) {
    const std::size_t count = std::min(kStrip, columns_.elements().size() - first);
    std::fill(w.begin(), w.end(), 0.0);
    for (std::size_t e = 0; e < count; ++e) {
      for (std::uint32_t k = starts[first + e]; k < starts[first + e + 1]; ++k) {
        const std::size_t lane = columns_.samples()[k] - first_sample;  // others wrap round
        if (lane < kRowLanes) w[e * kRowLanes + lane] = double{columns_.values()[k]};
      }
    }
    kernels::product_table().add_listed_products(w.data(), columns_.from(first), count, out.data(),
                                                 kRowLanes);
  }
}

void SampleProducts::write_elements(std::size_t first, std::size_t count,
                                    std::span<double> out) const {
  const std::size_t samples = samples_->count();
  for (std::size_t s = 0; s < samples; ++s) {
    const auto values = (*samples_)[s].values.subspan(first, count);
    for (std::size_t e = 0; e < count; ++e) out[e * samples + s] = double{values[e]};
  }
}

}  // namespace somato
