#include "base/text/iso_time.h"

#include <charconv>
#include <chrono>
#include <string>

#include "base/text/text.h"

namespace somato {
namespace {

constexpr int kMinute = 60;
constexpr int kHour = 60 * kMinute;
constexpr int kDay = 24 * kHour;

bool is_digit(char c) {
  return '0' <= c && c <= '9';
}

// Takes one part after the other off the front of a text.
class IsoReader {
 public:
  explicit IsoReader(std::string_view text) : rest_(text) {}

  std::optional<IsoTime> read() {
    IsoTime time;
    if (!date(time)) return std::nullopt;
    if (time.has_date && rest_.empty()) return time;
    const bool is_marked = take('T') || take('t');
    if (time.has_date && !is_marked && !take(' ')) return std::nullopt;
    if (is_basic_ && !is_marked) return std::nullopt;
    if (!clock(time, is_marked) || !zone(time) || !rest_.empty()) return std::nullopt;
    return time;
  }

 private:
  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::size_t digits() const {
    std::size_t count = 0;
    while (count < rest_.size() && is_digit(rest_[count])) ++count;
    return count;
  }

  // A number of exactly `length` digits.
  bool number(std::size_t length, int& value) {
    if (digits() < length) return false;
    std::from_chars(rest_.data(), rest_.data() + length, value);
    rest_.remove_prefix(length);
    return true;
  }

  // A date, or nothing if the text begins with a time of day.
  bool date(IsoTime& time) {
    constexpr std::size_t kYear = 4;
    constexpr std::size_t kBasicDate = 8;
    is_basic_ = digits() == kBasicDate;
    if (!is_basic_ && digits() != kYear) return true;
    int year = 0;
    int month = 0;
    int day = 0;
    if (!number(kYear, year) || (!is_basic_ && !take('-')) || !number(2, month) ||
        (!is_basic_ && !take('-')) || !number(2, day)) {
      return false;
    }
    const std::chrono::year_month_day whole{std::chrono::year(year),
                                            std::chrono::month(static_cast<unsigned>(month)),
                                            std::chrono::day(static_cast<unsigned>(day))};
    time.has_date = whole.ok();
    if (time.has_date) {
      time.seconds = std::int64_t{kDay} * std::chrono::sys_days(whole).time_since_epoch().count();
    }
    return time.has_date;
  }

  // A time of day, whose basic format has no colons and follows a T.
  bool clock(IsoTime& time, bool is_marked) {
    int hour = 0;
    int minute = 0;
    int second = 0;
    if (!number(2, hour)) return false;
    const bool has_colons = take(':');
    if (!has_colons && !is_marked) return false;
    if (!number(2, minute)) return false;
    const bool has_seconds = has_colons ? take(':') : digits() > 0;
    if (has_seconds && (!number(2, second) || !fraction(time))) return false;
    const int seconds = hour * kHour + minute * kMinute + second;
    if (minute >= 60 || second > 60 || hour > 24) return false;
    if (hour == 24 && (seconds != kDay || time.fraction > 0.0)) return false;
    time.seconds += seconds;
    return true;
  }

  bool fraction(IsoTime& time) {
    if (!take('.') && !take(',')) return true;
    const std::size_t length = digits();
    const std::string text = "0." + std::string(rest_.substr(0, length));
    rest_.remove_prefix(length);
    std::from_chars(text.data(), text.data() + text.size(), time.fraction);
    return length > 0 && time.fraction < 1.0;
  }

  bool zone(IsoTime& time) {
    if (rest_.empty()) return true;
    take(' ');
    time.has_zone = true;
    if (take('Z') || take('z')) return true;
    const bool is_west = rest_.starts_with('-');
    if (!take('+') && !take('-')) return false;
    int hours = 0;
    int minutes = 0;
    if (!number(2, hours)) return false;
    if ((take(':') || !rest_.empty()) && !number(2, minutes)) return false;
    if (hours >= 24 || minutes >= 60) return false;
    const int ahead = hours * kHour + minutes * kMinute;
    time.seconds -= is_west ? -ahead : ahead;
    return true;
  }

  std::string_view rest_;
  bool is_basic_ = false;
};

}  // namespace

std::optional<IsoTime> read_iso_time(std::string_view text) {
  return IsoReader(trimmed(text)).read();
}

}  // namespace somato
