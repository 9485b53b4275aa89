#include "maps/t_mpsom/t_mpsom_moving.h"

#include <algorithm>
#include <cmath>

#include "base/core/lanes.h"
#include "maps/t_mpsom/t_mpsom_arbor.h"

namespace somato {
namespace {

constexpr std::size_t kBlocks = TMpsomArbor::kBlocks;

double moved(float weight, float element, float gain) {
  return double{weight} + double{gain} * (double{element} - double{weight});
}

// In double precision, where nothing overflows.
void move_row(LaneMatrix<float>& weights, std::size_t row, std::span<const float> sample,
              float gain) {
  double squared = 0.0;
  for (std::size_t k = 0; k < weights.columns(); ++k) {
    const double weight = moved(weights(row, k), sample[k], gain);
    squared = std::fma(weight, weight, squared);
  }
  const double length = squared > 0.0 ? std::sqrt(squared) : 1.0;
  for (std::size_t k = 0; k < weights.columns(); ++k) {
    weights(row, k) = static_cast<float>(moved(weights(row, k), sample[k], gain) / length);
  }
}

// A few blocks of neurons.
class Group {
 public:
  Group(LaneMatrix<float>& weights, const TMpsomMove& move, std::size_t block)
      : weights_(weights),
        move_(move),
        row_(block * kFloatLanes),
        blocks_(std::min(kBlocks, weights.blocks() - block)),
        gains_(move.gains.data() + row_) {}

  void move(TMpsomNorm norm) {
    const kernels::TMpsomTable& kernels = kernels::t_mpsom_table();
    if (!move_.all_rows && !kernels.any(gains_, blocks_)) return;
    if (norm == TMpsomNorm::kNone) {
      kernels.find_plain_moves(gains_, blocks_, moves());
    } else if (!kernels.find_unit_moves({lanes(), blocks_, weights_.columns()}, move_.sample.data(),
                                        move_.squared_length, gains_, moves())) {
      move_doubtful_rows(weights_, {row_, blocks_}, move_.sample, gains_, moves());
    }
    kernels.move({lanes(), blocks_, weights_.columns()}, move_.sample.data(), moves());
  }

 private:
  float* lanes() const { return weights_.data() + row_ * weights_.columns(); }
  kernels::Moves moves() { return {keep_, add_, doubtful_}; }

  LaneMatrix<float>& weights_;
  const TMpsomMove& move_;
  std::size_t row_;
  std::size_t blocks_;
  const float* gains_;
  alignas(64) float keep_[kBlocks * kFloatLanes];
  alignas(64) float add_[kBlocks * kFloatLanes];
  alignas(64) float doubtful_[kBlocks * kFloatLanes];
};

}  // namespace

void move_doubtful_rows(LaneMatrix<float>& weights, const TMpsomRows& rows,
                        std::span<const float> sample, const float* gains,
                        const kernels::Moves& moves) {
  for (std::size_t lane = 0; lane < rows.blocks * kFloatLanes; ++lane) {
    if (moves.doubtful[lane] == 0.0F) continue;
    const std::size_t row = rows.first + lane;
    if (row < weights.rows()) move_row(weights, row, sample, gains[lane]);
    moves.keep[lane] = 1.0F;
    moves.add[lane] = 0.0F;
  }
}

void move_weights(LaneMatrix<float>& weights, const TMpsomMove& move, TMpsomNorm norm) {
  for (std::size_t block = 0; block < weights.blocks(); block += kBlocks) {
    Group(weights, move, block).move(norm);
  }
}

}  // namespace somato
