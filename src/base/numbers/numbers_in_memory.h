#pragma once

#include <cstddef>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/numbers/number_source.h"
#include "base/numbers/whole_table.h"

namespace somato {

/// The rows of a table in memory, as one part.
class NumbersInMemory final : public NumberSource {
 public:
  explicit NumbersInMemory(WholeTable whole)
      : columns_(std::move(whole.columns)),
        part_(std::make_shared<const NumberPart>(
            NumberPart{Samples(std::move(whole.table.values)), std::move(whole.table.labels)})) {}

  const TableColumns& columns() const override { return columns_; }
  std::size_t extent() const override { return part_->samples.count() * row_bytes(); }
  void take_places(std::size_t begin, std::size_t end) override {
    std::vector<std::size_t> rows(first_row_at(end, row_bytes()) -
                                  first_row_at(begin, row_bytes()));
    std::iota(rows.begin(), rows.end(), first_row_at(begin, row_bytes()));
    std::vector<std::string> labels;
    if (!part_->labels.empty()) {
      labels.reserve(rows.size());
      for (const std::size_t row : rows) labels.push_back(part_->labels[row]);
    }
    part_ = std::make_shared<const NumberPart>(
        NumberPart{part_->samples.subset(rows), std::move(labels)});
  }
  double memory_of_all() const override { return 0.0; }
  double share_read() const override { return is_read_ ? 1.0 : 0.0; }
  Result<void> rewind() override {
    is_read_ = false;
    return {};
  }
  Result<std::shared_ptr<const NumberPart>> next_part() override {
    const bool is_over = std::exchange(is_read_, true) || part_->samples.count() == 0;
    return is_over ? nullptr : part_;
  }

 private:
  std::size_t row_bytes() const { return size() * sizeof(float); }

  TableColumns columns_;
  std::shared_ptr<const NumberPart> part_;
  bool is_read_ = false;
};

}  // namespace somato
