#include "base/numbers/joined_numbers.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace somato {

JoinedNumbers::JoinedNumbers(std::vector<std::unique_ptr<NumberSource>> files)
    : files_(std::move(files)) {
  places_.reserve(files_.size());
  for (const auto& file : files_) places_.push_back(file->extent());
}

std::size_t JoinedNumbers::extent() const {
  return std::accumulate(places_.begin(), places_.end(), std::size_t{0});
}

void JoinedNumbers::take_places(std::size_t begin, std::size_t end) {
  std::size_t first = 0;  // the place of the next file
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const std::size_t last = first + places_[i];
    const std::size_t from = std::clamp(begin, first, last);
    const std::size_t to = std::clamp(end, first, last);
    files_[i]->take_places(from - first, to - first);
    places_[i] = to - from;
    first = last;
  }
}

std::vector<std::string> JoinedNumbers::rounded() const {
  std::vector<std::string> all;
  for (const auto& file : files_) {
    const std::vector<std::string> of_file = file->rounded();
    all.insert(all.end(), of_file.begin(), of_file.end());
  }
  return all;
}

double JoinedNumbers::memory_of_all() const {
  double memory = 0.0;
  for (const auto& file : files_) memory += file->memory_of_all();
  return memory;
}

double JoinedNumbers::share_read() const {
  double read = 0.0;
  for (std::size_t i = 0; i < std::min(current_ + 1, files_.size()); ++i) {
    read += files_[i]->share_read() * static_cast<double>(places_[i]);
  }
  const std::size_t all = extent();
  return all > 0 ? read / static_cast<double>(all) : 1.0;
}

Result<void> JoinedNumbers::rewind() {
  current_ = 0;
  for (const auto& file : files_) {
    SOMATO_TRY_VOID(file->rewind());
  }
  return {};
}

Result<std::shared_ptr<const NumberPart>> JoinedNumbers::next_part() {
  for (; current_ < files_.size(); ++current_) {
    SOMATO_TRY(auto part, files_[current_]->next_part());
    if (part) return part;
  }
  return std::shared_ptr<const NumberPart>();
}

}  // namespace somato
