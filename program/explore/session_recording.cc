#include "explore/session_recording.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <optional>
#include <string_view>

#include "flags/memory_flag.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

// A time such as 30min, in seconds.
std::optional<double> seconds_in(const std::string& text) {
  constexpr std::pair<std::string_view, double> kUnits[] = {
      {"s", 1.0}, {"min", 60.0}, {"h", 3600.0}, {"d", 86400.0}};
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || !(number > 0.0)) return {};
  for (const auto& [name, seconds] : kUnits) {
    if (std::string_view(stop, static_cast<std::size_t>(end - stop)) == name) {
      return number * seconds;
    }
  }
  return {};
}

}  // namespace

Result<void> SessionRecording::begin() {
  if (path_.empty()) return {};
  SOMATO_TRY(file_, GrowingRecording::begin(path_, rollover_));
  return {};
}

Result<std::string> SessionRecording::finish() {
  if (!file_) return std::string();
  SOMATO_TRY_VOID(file_->finish());
  if (file_->count() > 0) return saved_text(*file_) + "\n";
  return fmt::format("{}: not written, because the body explored nothing\n", path_);
}

Flag every_flag() {
  return {"--every",
          "Begin another file for the recording after this time or size, such as 1h or 500MB; the "
          "name of the file contains {time}, the time at which it begins"};
}

Result<Rollover> read_rollover(const Arguments& arguments) {
  Rollover rollover;
  if (!arguments.has("every")) return rollover;
  if (arguments.text("output").find(kTimePlace) == std::string::npos) {
    return fail(ErrorKind::kUsage, "each file needs a name of its own", "--every",
                "use it with a name such as -o 'touch_{time}.mcap'");
  }
  const std::string text = arguments.text("every");
  if (const auto seconds = seconds_in(text)) {
    rollover.every = *seconds;
    return rollover;
  }
  const auto bytes = bytes_in(text, "--every");
  const bool has_unit = !text.empty() && std::isalpha(static_cast<unsigned char>(text.back())) != 0;
  if (!bytes || !has_unit) {
    return fail(ErrorKind::kUsage, "must be a time or a size", "--every",
                "write a number and a unit, such as 30min, 1h, 1d or 500MB");
  }
  rollover.bytes = *bytes;
  return rollover;
}

std::string losses_text(const Losses& losses) {
  std::string text;
  const auto add = [&](std::size_t count, const std::string& what, const std::string& outcome) {
    if (count == 0) return;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counted(count, what), outcome);
  };
  add(losses.failed, "exploration", "failed");
  add(losses.unsaved, "exploration", "could not be saved");
  add(losses.viewers, "viewer", "left");
  return text.empty() ? text : text + "\n";
}

std::string saved_text(const GrowingRecording& file) {
  const std::string place =
      file.files() > 1 ? fmt::format("{}, to {}", counted(file.files(), "file"), file.path())
                       : file.path();
  return fmt::format("{} saved in {}", counted(file.count(), "exploration"), place);
}

}  // namespace somato::program
