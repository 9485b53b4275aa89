#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/numbers/number_source.h"

namespace somato {

/// The rows of several sources with the same columns, one source after the other.
class JoinedNumbers final : public NumberSource {
 public:
  /// `files` are not empty.
  explicit JoinedNumbers(std::vector<std::unique_ptr<NumberSource>> files);

  const TableColumns& columns() const override { return files_.front()->columns(); }
  std::size_t extent() const override;
  void take_places(std::size_t begin, std::size_t end) override;
  std::vector<std::string> rounded() const override;
  double memory_of_all() const override;
  double share_read() const override;
  Result<void> rewind() override;
  Result<std::shared_ptr<const NumberPart>> next_part() override;

 private:
  std::vector<std::unique_ptr<NumberSource>> files_;
  std::vector<std::size_t> places_;  // those of each file that are read
  std::size_t current_ = 0;
};

}  // namespace somato
