#include "reproduce/sweep_run.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "base/archives/checksum.h"
#include "flags/output_folder.h"
#include "version.h"

namespace somato::program {

SweepRun::SweepRun(SweepRequest& request)
    : request_(request),
      recordings_(request.pairs, request.out / "recordings"),
      runner_(request.pairs, recordings_),
      kept_(parts_folder(request.out), request.part.folder_name()) {}

Result<void> SweepRun::make_folders() const {
  return make_folder(request_.out / "recordings").and_then([&] { return kept_.make_folders(); });
}

Result<void> SweepRun::run() {
  kept_.look();
  SOMATO_TRY(auto missing, missing_points());
  SweepProgress progress(names_of(request_.sweep), missing.size());
  for (const std::size_t number : missing) {
    auto ran = run_point(request_.points[number], progress);
    if (!ran) return ran;
    progress.end_point();
  }
  if (!missing.empty()) progress.end();
  std::error_code not_empty;
  std::filesystem::remove(kept_.unfinished(), not_empty);
  return {};
}

Result<SweepResults> SweepRun::results() {
  kept_.look();
  SweepResults results{request_.sweep, {}};
  for (const SweepPoint& point : request_.points) {
    SOMATO_TRY(auto parts, found_at(point));
    if (parts) results.points.push_back(judge_point(request_.sweep, point, *parts));
  }
  return results;
}

Result<std::string> SweepRun::name_of(const ReproductionPart& part) {
  return runner_.identity(part).map(
      [](const std::string& text) { return checksum_name(SOMATO_VERSION + ("\n" + text)); });
}

Result<std::optional<std::vector<PartResults>>> SweepRun::found_at(const SweepPoint& point) {
  SOMATO_TRY(const auto plan, plan_of_point(request_.sweep, point));
  std::optional<std::vector<PartResults>> parts{std::in_place};
  for (const ReproductionPart& part : plan.parts) {
    SOMATO_TRY(const auto name, name_of(part));
    auto found = kept_.find(name);
    if (!found) return std::optional<std::vector<PartResults>>{};
    parts->push_back(std::move(*found));
  }
  return parts;
}

Result<std::vector<std::size_t>> SweepRun::missing_points() {
  std::vector<std::size_t> missing;
  const Part& part = request_.part;
  for (std::size_t i = part.number - 1; i < request_.points.size(); i += part.of) {
    SOMATO_TRY(const auto found, found_at(request_.points[i]));
    if (!found) missing.push_back(i);
  }
  return missing;
}

Result<void> SweepRun::run_point(const SweepPoint& point, SweepProgress& progress) {
  SOMATO_TRY(const auto plan, plan_of_point(request_.sweep, point));
  for (std::size_t i = 0; i < plan.parts.size(); ++i) {
    progress.begin_study(i, plan.parts.size());
    auto ran = run_study_at(point, plan.parts[i], progress);
    if (!ran) return ran;
  }
  return {};
}

Result<void> SweepRun::run_study_at(const SweepPoint& point, const ReproductionPart& part,
                                    const SweepProgress& progress) {
  SOMATO_TRY(const auto name, name_of(part));
  if (kept_.find(name)) return {};
  std::vector<std::filesystem::path> journals;
  const PartEvents events{
      [&](std::size_t index, std::size_t count) { return progress.of_recording(index, count); },
      [&](std::size_t index) {
        journals.push_back(kept_.unfinished() / fmt::format("{}-{}.journal", name, index));
        return journals.back().string();
      }};
  auto ran = runner_.run(part, events);
  if (ran && ran->misfit) ran = fail(std::move(*ran->misfit));
  if (!ran) return fail(at_point(std::move(ran.error()), point));
  SOMATO_TRY_VOID(kept_.keep(name, ran->results));
  std::error_code gone;
  for (const std::filesystem::path& journal : journals) std::filesystem::remove(journal, gone);
  return {};
}

Error SweepRun::at_point(Error error, const SweepPoint& point) const {
  if (error.kind == ErrorKind::kInterrupted) return error;
  error.what += " (at " + name_of_point(request_.sweep.sweep, point) + ")";
  return error;
}

}  // namespace somato::program
