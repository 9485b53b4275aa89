#include "recordings/imports/yarp_dumps.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/files/whole_file.h"
#include "base/text/flag_hint.h"
#include "base/text/number_of_text.h"
#include "base/text/text.h"
#include "recordings/explorations/clock_times.h"
#include "recordings/explorations/element_order.h"
#include "recordings/tables/files_below.h"
#include "recordings/tables/name_pattern.h"

namespace somato {
namespace {

constexpr const char* kDataLog = "data.log";
constexpr const char* kInfoLog = "info.log";
constexpr std::size_t kLongestInfo = std::size_t{1} << 20;
constexpr double kMicrosecondsASecond = 1e6;

// A folder with a dump.
struct Dump {
  std::filesystem::path folder;
  std::string exploration;  // The path below the imported folder.
  std::string channel;
  std::vector<Label> labels;
};

// The relevant lines of info.log; older versions of the dumper wrote none.
struct DumpInfo {
  bool is_bottle = true;
  bool has_two_stamps = false;
};

Result<DumpInfo> read_info(const std::filesystem::path& folder) {
  DumpInfo info;
  const std::filesystem::path path = folder / kInfoLog;
  std::error_code missing;
  if (!std::filesystem::exists(path, missing)) return info;
  SOMATO_TRY(const std::string bytes, read_whole(path.string(), kLongestInfo));
  for (const std::string& line : split(bytes, '\n')) {
    if (line.starts_with("Type:")) info.is_bottle = line.starts_with("Type: Bottle;");
    if (line.starts_with("Stamp:")) info.has_two_stamps = line.starts_with("Stamp: tx+rx;");
  }
  return info;
}

// Also one that is not finite or too large.
bool is_numeral(std::string_view text) {
  double number = 0.0;
  const char* end = text.data() + text.size();
  return std::from_chars(text.data(), end, number).ptr == end;
}

std::optional<double> number_of_dump(std::string_view text) {
  const auto number = number_of_text<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

// The words of a line; parentheses of lists separate them too.
std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBetween = " \t\r()";
  std::vector<std::string_view> words;
  std::size_t start = line.find_first_not_of(kBetween);
  while (start != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBetween, start), line.size());
    words.push_back(line.substr(start, end - start));
    start = line.find_first_not_of(kBetween, end);
  }
  return words;
}

// The number of numbers after the word `i`.
std::size_t numbers_after(std::span<const std::string_view> words, std::size_t i) {
  const auto begin = words.begin() + static_cast<std::ptrdiff_t>(i + 1);
  const auto end = std::find_if_not(begin, words.end(), number_of_dump);
  return static_cast<std::size_t>(end - begin);
}

// Whether the words are names, each with numbers after it, as in (shoulder 12.5) (hand 0.1 0.2).
bool are_named_values(std::span<const std::string_view> words) {
  for (std::size_t i = 0; i < words.size();) {
    const std::size_t count = numbers_after(words, i);
    if (is_numeral(words[i]) || count == 0) return false;
    i += 1 + count;
  }
  return true;
}

// Reads the lines of a data.log.
class DumpReader {
 public:
  DumpReader(std::string_view text, std::string where, const DumpInfo& info, ElementOrder& order)
      : text_(text),
        where_(std::move(where)),
        before_values_(info.has_two_stamps ? 3 : 2),
        order_(&order) {}

  // The channel with times in seconds since 1970, or nothing if its first line contains text that
  // does not name its values.
  Result<std::optional<Channel>> read(const std::string& name) {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      const std::vector<std::string_view> words = words_of(text_.substr(0, end));
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++line_;
      if (words.empty()) continue;
      SOMATO_TRY_VOID(read_line(words));
      if (is_text_) return std::optional<Channel>();
    }
    if (times_.empty()) return bad("there are no lines");
    Channel channel{name, "", is_named_ ? order_->names() : std::vector<std::string>(),
                    Matrix<float>(times_.size(), elements_, std::move(values_)), std::move(times_)};
    return std::optional(std::move(channel));
  }

 private:
  Result<void> read_line(const std::vector<std::string_view>& words) {
    if (words.size() <= before_values_) {
      return bad(fmt::format("the line has {} words, and none for values", words.size()));
    }
    const std::optional<double> time = number_of_dump(words[1]);
    if (!time) return bad(fmt::format("{} is not a time stamp", shown(words[1])));
    if (!times_.empty() && *time < times_.back()) {
      return bad("the time stamp precedes that of the preceding line");
    }
    const std::span<const std::string_view> content = std::span(words).subspan(before_values_);
    if (times_.empty()) {
      is_named_ = are_named_values(content);
      is_text_ = !is_named_ && !std::all_of(content.begin(), content.end(), number_of_dump);
      if (is_text_) return {};
    }
    SOMATO_TRY_VOID(is_named_ ? take_named(content) : take(content));
    if (!times_.empty() && line_values_.size() != elements_) {
      return bad(
          fmt::format("the line has {} values, the first one {}", line_values_.size(), elements_));
    }
    elements_ = line_values_.size();
    for (const double value : line_values_) values_.push_back(static_cast<float>(value));
    times_.push_back(*time);
    return {};
  }

  Result<void> take(std::span<const std::string_view> content) {
    line_values_.clear();
    for (const std::string_view word : content) {
      const std::optional<double> value = number_of_dump(word);
      if (!value || std::fabs(*value) > std::numeric_limits<float>::max()) {
        return bad(fmt::format("{} is not a finite number", shown(word)));
      }
      line_values_.push_back(*value);
    }
    return {};
  }

  Result<void> take_named(std::span<const std::string_view> content) {
    if (!are_named_values(content)) return bad("the line has values without names");
    std::vector<std::string_view> numbers;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < content.size();) {
      const std::size_t count = numbers_after(content, i);
      for (std::size_t j = 0; j < count; ++j) {
        names.push_back(count == 1 ? std::string(content[i])
                                   : fmt::format("{}[{}]", content[i], j));
        numbers.push_back(content[i + 1 + j]);
      }
      i += 1 + count;
    }
    SOMATO_TRY_VOID(take(numbers));
    const std::string key = fmt::format("{}", fmt::join(names, "\n"));
    if (!order_->is_known(key)) {
      const Result<void> learnt = order_->learn(key, names);
      if (!learnt) return bad(learnt.error().what);
    }
    order_->place(line_values_);
    return {};
  }

  tl::unexpected<Error> bad(std::string what) const {
    return fail(ErrorKind::kData, std::move(what), fmt::format("{}:{}", where_, line_),
                "repair the file, or move its folder elsewhere");
  }

  std::string_view text_;
  std::string where_;
  std::size_t before_values_;  // The number of words before the values.
  std::size_t line_ = 0;
  std::size_t elements_ = 0;
  bool is_text_ = false;
  bool is_named_ = false;
  ElementOrder* order_;  // The order of the channel in all explorations.
  std::vector<double> line_values_;
  std::vector<float> values_;
  std::vector<double> times_;
};

// Divides the path of a dump into those of the exploration and of the channel.
class DumpFinder {
 public:
  DumpFinder(std::filesystem::path folder, std::optional<NamePattern> pattern)
      : folder_(std::move(folder)), pattern_(std::move(pattern)) {
    if (!pattern_) return;
    parts_ = 1 + static_cast<std::size_t>(
                     std::count(pattern_->text().begin(), pattern_->text().end(), '/'));
  }

  // The dump with that data.log, or nothing if the pattern does not fit its folder.
  Result<std::optional<Dump>> dump_of(const std::string& file) const {
    std::vector<std::string> parts = split(file, '/');
    parts.pop_back();
    Dump dump{(folder_ / file).parent_path(), {}, {}, {}};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      std::string& path = i < parts_ ? dump.exploration : dump.channel;
      path += (path.empty() ? "" : "/") + parts[i];
    }
    if (dump.channel.empty()) {
      dump.channel = std::filesystem::weakly_canonical(dump.folder).filename().string();
    }
    if (!pattern_) return std::optional(std::move(dump));
    if (parts.size() < parts_) return std::optional<Dump>();
    SOMATO_TRY(auto labels, pattern_->match(dump.exploration));
    if (!labels) return std::optional<Dump>();
    dump.labels = std::move(*labels);
    return std::optional(std::move(dump));
  }

 private:
  std::filesystem::path folder_;
  std::optional<NamePattern> pattern_;
  std::size_t parts_ = 0;  // The number of parts of the path of an exploration.
};

Result<std::vector<Dump>> find_dumps(const std::filesystem::path& folder, const std::string& files,
                                     bool pass_over_others) {
  std::optional<NamePattern> pattern;
  if (!files.empty()) {
    SOMATO_TRY(pattern, NamePattern::parse(files));
  }
  const DumpFinder finder(folder, std::move(pattern));
  SOMATO_TRY(const std::vector<std::string> found, files_below(folder, kDataLog));
  std::vector<Dump> dumps;
  for (const std::string& file : found) {
    if (std::filesystem::path(file).filename() != kDataLog) continue;
    SOMATO_TRY(std::optional<Dump> dump, finder.dump_of(file));
    if (dump) {
      dumps.push_back(std::move(*dump));
    } else if (!pass_over_others) {
      return fail(
          ErrorKind::kData, fmt::format("the folder does not match the pattern \"{}\"", files),
          (folder / file).parent_path().string(),
          "correct the pattern, or ignore other files" + flag_hint("other-files", "ignore"));
    }
  }
  if (!dumps.empty()) return dumps;
  return fail(ErrorKind::kData, "there are no dumps of YARP (folders with a data.log)",
              folder.string());
}

Result<std::optional<Channel>> read_dump(const Dump& dump, ElementOrder& order,
                                         std::vector<std::string>& left_out) {
  const std::string path = (dump.folder / kDataLog).string();
  SOMATO_TRY(const DumpInfo info, read_info(dump.folder));
  if (!info.is_bottle) {
    left_out.push_back(dump.folder.string() + ": images");
    return std::optional<Channel>();
  }
  SOMATO_TRY(const std::string bytes, read_whole(path));
  SOMATO_TRY(const std::string_view text, text_of(bytes, path));
  SOMATO_TRY(std::optional<Channel> channel,
             DumpReader(text, path, info, order).read(dump.channel));
  if (!channel) left_out.push_back(dump.folder.string() + ": text");
  return channel;
}

// A dump without time stamps, or of a computer whose clock was not set, would lie decades apart.
Result<void> check_clocks(const Exploration& exploration) {
  ClockTimes clock;
  for (const Channel& channel : exploration.channels) {
    for (const double time : channel.times) {
      clock.take(
          time, [&] { return fmt::format("{}", time); },
          [&] { return (std::filesystem::path(exploration.source) / channel.name).string(); });
    }
  }
  return clock.check("the dumps");
}

void make_times_relative(Exploration& exploration) {
  double first = exploration.channels.front().times.front();
  for (const Channel& channel : exploration.channels)
    first = std::min(first, channel.times.front());
  for (Channel& channel : exploration.channels) {
    for (double& time : channel.times) {
      time = std::round((time - first) * kMicrosecondsASecond) / kMicrosecondsASecond;
    }
  }
}

}  // namespace

Result<YarpImport> import_yarp_dumps(const std::filesystem::path& folder, const std::string& files,
                                     bool pass_over_others) {
  SOMATO_TRY(const std::vector<Dump> dumps, find_dumps(folder, files, pass_over_others));
  YarpImport import;
  std::vector<Exploration>& explorations = import.recording.explorations;
  std::map<std::string, ElementOrder> orders;
  std::string latest;
  for (const Dump& dump : dumps) {
    SOMATO_TRY(std::optional<Channel> channel,
               read_dump(dump, orders[dump.channel], import.left_out));
    if (!channel) continue;
    if (explorations.empty() || dump.exploration != latest) {
      explorations.push_back({dump.labels, (folder / dump.exploration).string(), {}});
    }
    latest = dump.exploration;
    explorations.back().channels.push_back(std::move(*channel));
  }
  if (explorations.empty()) {
    return fail(ErrorKind::kData, "no dump contains numbers", folder.string());
  }
  for (Exploration& exploration : explorations) {
    SOMATO_TRY_VOID(check_clocks(exploration));
    make_times_relative(exploration);
    Result<void> alike = check_alike(exploration, explorations.front());
    if (!alike) {
      alike.error().where = exploration.source;
      return fail(std::move(alike.error()));
    }
  }
  return import;
}

}  // namespace somato
