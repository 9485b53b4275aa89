#include "base/files/text_window.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/text.h"

namespace somato {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18;
constexpr std::size_t kLongestCharacter = 4;

}  // namespace

void TextWindow::drop(std::size_t count) {
  text_.erase(0, count);
  checked_ -= count;
}

void TextWindow::rewind() {
  text_.clear();
  checked_ = 0;
  place_ = 0;
  lines_ = 0;
}

// Appends the bytes that were read; an incomplete character remains for the next call.
Result<void> TextWindow::check(bool ended) {
  const std::string_view fresh = std::string_view(text_).substr(checked_);
  const std::size_t bad = first_byte_of_no_text(fresh);
  const std::size_t good = std::min(bad, fresh.size());
  const bool cut = !ended && fresh.size() - good < kLongestCharacter;
  if (good < fresh.size() && !cut) return no_text(fresh, bad, lines_, where_);
  lines_ += static_cast<std::size_t>(
      std::count(fresh.begin(), fresh.begin() + static_cast<std::ptrdiff_t>(good), '\n'));
  checked_ += good;
  return {};
}

// Twice as much each time, so that reading a long record again and again takes no longer than it
// is.
Result<bool> TextWindow::extend() {
  const std::size_t old = text_.size();
  const std::size_t room = std::max(kBlock, old);
  if (old + room > kLargest) {
    return fail(ErrorKind::kData, fmt::format("a row is longer than {} bytes", kLargest / 2),
                fmt::format("{}:{}", where_, lines_ + 1), "check that it is the right file");
  }
  text_.resize(old + room);
  const auto got = file_.read_all_at(place_, text_.data() + old, room);
  if (!got) return system_failure("cannot read", where_, got.error());
  text_.resize(old + *got);
  const bool beginning = place_ == 0;
  place_ += *got;
  SOMATO_TRY_VOID(check(*got < room));
  if (beginning && text().starts_with(kByteOrderMark)) drop(kByteOrderMark.size());
  return *got > 0;
}

}  // namespace somato
