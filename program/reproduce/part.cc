#include "reproduce/part.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

#include "base/text/number_of_text.h"
#include "flags/output_folder.h"
#include "flags/result_output.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

constexpr std::size_t kMostPartsOfWork = 1'000'000;
constexpr const char* kTask = "SLURM_ARRAY_TASK_ID";

std::optional<std::size_t> whole_number(std::string_view text) {
  const auto number = number_of_text<std::size_t>(text);
  return number && *number <= kMostPartsOfWork ? number : std::nullopt;
}

Result<Part> part_named(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto number = whole_number(text.substr(0, slash));
  const auto of = slash == std::string::npos ? std::nullopt : whole_number(text.substr(slash + 1));
  if (!number || !of || *number < 1 || *number > *of) {
    return fail(ErrorKind::kUsage, "'" + text + "' is not a part", "--part",
                "write K/N with K from 1 to N, such as 3/7");
  }
  return Part{{*number, *of}, {}};
}

// A variable of the environment, or `otherwise` if it is not set.
Result<std::size_t> slurm_number(const char* name, std::size_t otherwise) {
  const char* text = std::getenv(name);
  if (!text) return otherwise;
  if (const auto number = whole_number(text)) return *number;
  return fail(ErrorKind::kUsage, fmt::format("'{}' is not a task number", text), name,
              "give --part K/N");
}

Result<Part> slurm_part() {
  const auto task = slurm_number(kTask, 0);
  const auto first = slurm_number("SLURM_ARRAY_TASK_MIN", 1);
  const auto step = slurm_number("SLURM_ARRAY_TASK_STEP", 1);
  const auto count = slurm_number("SLURM_ARRAY_TASK_COUNT", 0);
  for (const auto* number : {&task, &first, &step, &count}) {
    if (!*number) return fail(number->error());
  }
  const bool follows = *step > 0 && *task >= *first && (*task - *first) % *step == 0;
  const std::size_t number = follows ? (*task - *first) / *step + 1 : 0;
  if (number < 1 || number > *count) {
    return fail(ErrorKind::kUsage,
                fmt::format("task {} is not one of {} tasks from {} in steps of {}", *task, *count,
                            *first, *step),
                kTask, "use an array without gaps, such as --array=1-7, or --part K/N");
  }
  return Part{{number, *count}, fmt::format("{} = {}", kTask, *task)};
}

}  // namespace

Flag part_flag(const std::string& unit) {
  return {"--part", fmt::format("K/N: run {0} K and every N-th {0} after it. Default: the part of "
                                "the Slurm array task, or otherwise all {0}s",
                                unit)};
}

Result<Part> read_part(const Arguments& arguments) {
  if (arguments.has("part")) return part_named(arguments.text("part"));
  return std::getenv(kTask) ? slurm_part() : Part{};
}

std::filesystem::path parts_folder(const std::filesystem::path& out) {
  return out / "parts";
}

Result<FolderLock> lock_work(const std::filesystem::path& out, const Part& part) {
  if (part.is_whole()) return FolderLock::take(out);
  const std::filesystem::path own = parts_folder(out) / part.folder_name();
  return make_folder(own).and_then([&] { return FolderLock::take(own); });
}

std::string part_text(const Part& part) {
  if (part.is_whole() && part.given_by.empty()) return {};
  const std::string by = part.given_by.empty() ? "" : " (" + part.given_by + ")";
  return fmt::format("Part {} of {}{} is done.\n", part.number, part.of, by);
}

void print_part(const Arguments& arguments, const Part& part,
                std::pair<std::size_t, std::size_t> done_of, const std::string& unit,
                const std::string& file) {
  const auto [done, total] = done_of;
  const std::string text = fmt::format(
      "{}{} of {} are complete. The last part writes {}, and so does the same command without "
      "--part, which runs missing {}s.\n",
      part_text(part), done, counted(total, unit), file, unit);
  print_summary(
      arguments, text,
      Table{{},
            {entry("part", std::uint64_t{part.number}), entry("parts", std::uint64_t{part.of}),
             entry("done", std::uint64_t{done}), entry(unit + "s", std::uint64_t{total})}});
}

}  // namespace somato::program
