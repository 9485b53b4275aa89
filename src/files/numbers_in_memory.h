#pragma once

#include <memory>
#include <utility>

#include "files/number_source.h"
#include "files/whole_table.h"

namespace somato {

/// The rows of a table in memory, as one part.
class NumbersInMemory final : public NumberSource {
 public:
  explicit NumbersInMemory(WholeTable whole)
      : columns_(std::move(whole.columns)),
        part_(std::make_shared<const NumberPart>(
            NumberPart{Samples(std::move(whole.table.values)), std::move(whole.table.labels)})) {}

  const TableColumns& columns() const override { return columns_; }
  double memory_of_all() const override { return 0.0; }
  double share_read() const override { return is_read_ ? 1.0 : 0.0; }
  Result<void> rewind() override {
    is_read_ = false;
    return {};
  }
  Result<std::shared_ptr<const NumberPart>> next_part() override {
    return std::exchange(is_read_, true) ? nullptr : part_;
  }

 private:
  TableColumns columns_;
  std::shared_ptr<const NumberPart> part_;
  bool is_read_ = false;
};

}  // namespace somato
