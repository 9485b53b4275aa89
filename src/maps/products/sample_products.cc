#include "maps/products/sample_products.h"

#include <algorithm>
#include <utility>

#include "base/core/threads.h"
#include "base/kernels/product_kernels.h"
#include "maps/products/strip_rows.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

using kernels::kRowLanes;

constexpr std::size_t kStrip = 128;   // elements at a time: lines for them stay in the first cache
constexpr std::size_t kTogether = 8;  // blocks of sixteen samples that share the elements read

}  // namespace

std::shared_ptr<const SampleProducts> SampleProducts::of(const Samples& samples, bool normalized,
                                                         std::size_t threads) {
  return std::static_pointer_cast<const SampleProducts>(
      samples.computed_once(normalized ? 1 : 0, [&]() -> std::shared_ptr<const void> {
        SomParameters parameters;
        parameters.normalize_input = normalized;
        Samples storage;
        return std::make_shared<const SampleProducts>(
            prepared_samples(parameters, samples, storage).apart(), threads);
      }));
}

SampleProducts::SampleProducts(Samples samples, std::size_t threads)
    : samples_(std::move(samples)), products_(samples_.count(), samples_.count()) {
  if (samples_.is_sparse()) columns_ = SampleColumns(samples_);
  const std::size_t blocks = (samples_.count() + kRowLanes - 1) / kRowLanes;
  for_each_range(blocks, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; block += kTogether) {
      multiply(block, std::min(block + kTogether, end));
    }
  });
}

// Blocks of samples in the place of neurons.
void SampleProducts::multiply(std::size_t begin, std::size_t end) {
  const std::size_t samples = samples_.count();
  AlignedVector<double> lines((end - begin) * samples * kRowLanes);  // block by block
  if (samples_.is_sparse()) {
    multiply_sparse(begin, end, lines);
  } else {
    multiply_dense(begin, end, lines);
  }
  for (std::size_t row = begin * kRowLanes; row < std::min(end * kRowLanes, samples); ++row) {
    const std::size_t block = row / kRowLanes - begin;
    for (std::size_t s = 0; s < samples; ++s) {
      products_(row, s) = lines[(block * samples + s) * kRowLanes + row % kRowLanes];
    }
  }
}

void SampleProducts::multiply_dense(std::size_t begin, std::size_t end,
                                    AlignedVector<double>& lines) const {
  const std::size_t samples = samples_.count();
  AlignedVector<double> x(kStrip * samples);
  AlignedVector<double> w(kStrip * kRowLanes);
  for (std::size_t first = 0; first < samples_.size(); first += kStrip) {
    const std::size_t count = std::min(kStrip, samples_.size() - first);
    write_elements(first, count, x);
    for (std::size_t block = begin; block < end; ++block) {
      const std::size_t lanes = std::min(kRowLanes, samples - block * kRowLanes);
      for (std::size_t e = 0; e < count; ++e) {
        std::copy_n(&x[e * samples + block * kRowLanes], lanes, &w[e * kRowLanes]);
      }
      kernels::product_table().add_products(w.data(), x.data(), count, samples,
                                            &lines[(block - begin) * samples * kRowLanes],
                                            kRowLanes);
    }
  }
}

void SampleProducts::multiply_sparse(std::size_t begin, std::size_t end,
                                     AlignedVector<double>& lines) const {
  AlignedVector<double> w(kStrip * kRowLanes);
  StripRows rows;
  for (std::size_t first = 0; first < columns_.elements().size(); first += kStrip) {
    const std::size_t count = std::min(kStrip, columns_.elements().size() - first);
    rows.read(columns_.from(first), count, samples_.count());
    for (std::size_t block = begin; block < end; ++block) {
      write_lines(first, count, block * kRowLanes, w);
      rows.add_products(w.data(), &lines[(block - begin) * samples_.count() * kRowLanes],
                        kRowLanes);
    }
  }
}

// The values of sixteen sparse samples in some columns.
void SampleProducts::write_lines(std::size_t first, std::size_t count, std::size_t first_sample,
                                 AlignedVector<double>& lines) const {
  const auto starts = columns_.starts();
  std::fill(lines.begin(), lines.end(), 0.0);
  for (std::size_t e = 0; e < count; ++e) {
    for (std::uint32_t k = starts[first + e]; k < starts[first + e + 1]; ++k) {
      const std::size_t lane = columns_.samples()[k] - first_sample;  // others wrap round
      if (lane < kRowLanes) lines[e * kRowLanes + lane] = double{columns_.values()[k]};
    }
  }
}

void SampleProducts::write_elements(std::size_t first, std::size_t count,
                                    std::span<double> out) const {
  const std::size_t samples = samples_.count();
  for (std::size_t s = 0; s < samples; ++s) {
    const auto values = samples_[s].values.subspan(first, count);
    for (std::size_t e = 0; e < count; ++e) out[e * samples + s] = double{values[e]};
  }
}

}  // namespace somato
