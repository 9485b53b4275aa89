#include "reproduce/sweep_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <system_error>
#include <utility>

#include "base/archives/checksum.h"
#include "flags/output_folder.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {

SweepRun::SweepRun(SweepRequest& request)
    : request_(request),
      recordings_(request.pairs, request.out / "recordings"),
      runner_(request.pairs, recordings_),
      kept_(parts_folder(request.out), request.part.folder_name()),
      first_seed_(request.pairs.seed) {
  if (!stock()) return;
  recordings_.use_stock({request.out / "stock", first_seed_, *stock(), request.pairs.threads});
}

Result<void> SweepRun::make_folders() const {
  return make_folder(request_.out / (stock() ? "stock" : "recordings")).and_then([&] {
    return kept_.make_folders();
  });
}

Result<void> SweepRun::run() {
  kept_.look();
  SOMATO_TRY(auto missing, missing_points());
  if (stock()) SOMATO_TRY_VOID(explore_stock(missing));
  SweepProgress progress(names_of(request_.sweep), missing.size());
  for (const std::size_t number : missing) {
    auto ran = run_point(number, progress);
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
  for (std::size_t i = 0; i < request_.points.size(); ++i) {
    SOMATO_TRY(auto parts, found_at(i));
    if (parts) results.points.push_back(judge_point(request_.sweep, request_.points[i], *parts));
  }
  return results;
}

Result<std::string> SweepRun::name_of(const ReproductionPart& part) {
  return runner_.identity(part).map([](const std::string& text) {
    return checksum_name(fmt::format("{}\n{}", kVersionOfBits, text));
  });
}

Result<void> SweepRun::use_point(std::size_t number) {
  if (request_.targets) {
    const std::size_t seeds = std::max(request_.pairs.pairs, request_.pairs.recordings);
    request_.pairs.seed = first_seed_ + number * seeds;
    recordings_.use_seeds();
  }
  if (!stock()) return {};
  StockPoint point;
  point.first = request_.targets ? number * request_.pairs.recordings : 0;
  const SweepPoint explored = explored_point(request_.sweep.sweep, request_.points[number]);
  SOMATO_TRY(const auto plan, plan_of_point(request_.sweep, explored));
  for (const ReproductionPart& part : plan.parts) point.explored[title_of(part)] = part.explore;
  recordings_.use_stock_point(std::move(point));
  return {};
}

Result<std::map<std::string, StockFile>> SweepRun::stock_files(
    const std::vector<std::size_t>& points) {
  std::map<std::string, StockFile> all;
  const std::size_t recordings = std::min(request_.pairs.recordings, request_.pairs.pairs);
  for (const std::size_t number : points) {
    SOMATO_TRY_VOID(use_point(number));
    SOMATO_TRY(const auto plan, plan_of_point(request_.sweep, request_.points[number]));
    for (const ReproductionPart& part : plan.parts) {
      for (std::size_t index = 0; index < recordings; ++index) {
        SOMATO_TRY(const auto files, recordings_.stock().files(recordings_.stocked(part, index)));
        for (const StockFile& file : files) {
          SOMATO_TRY(const auto path, recordings_.stock().path(file));
          all.emplace(path, file);
        }
      }
    }
  }
  std::erase_if(all, [](const auto& one) { return std::filesystem::exists(one.first); });
  return all;
}

// Parts begin at different files, so that they share the work.
Result<void> SweepRun::explore_stock(const std::vector<std::size_t>& points) {
  SOMATO_TRY(const auto missing, stock_files(points));
  if (missing.empty()) return {};
  std::vector<StockFile> files;
  for (const auto& [path, file] : missing) files.push_back(file);
  const std::size_t first = files.size() * (request_.part.number - 1) / request_.part.of;
  std::rotate(files.begin(), files.begin() + static_cast<std::ptrdiff_t>(first), files.end());
  const auto begin = std::chrono::steady_clock::now();
  for (const StockFile& file : files) SOMATO_TRY_VOID(recordings_.stock().explore(file));
  if (is_quiet()) return {};
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  fmt::print(stderr, "somato: the stock of {} is complete; it took {:.0f} s\n",
             counted(files.size(), "file"), seconds.count());
  return {};
}

Result<std::optional<std::vector<PartResults>>> SweepRun::found_at(std::size_t number) {
  SOMATO_TRY_VOID(use_point(number));
  SOMATO_TRY(const auto plan, plan_of_point(request_.sweep, request_.points[number]));
  std::optional<std::vector<PartResults>> parts{std::in_place};
  for (const ReproductionPart& part : plan.parts) {
    SOMATO_TRY(const auto name, name_of(part));
    SOMATO_TRY(auto found, kept_.find(name));
    if (!found) return std::optional<std::vector<PartResults>>{};
    parts->push_back(std::move(*found));
  }
  return parts;
}

Result<std::vector<std::size_t>> SweepRun::missing_points() {
  std::vector<std::size_t> missing;
  const Part& part = request_.part;
  for (std::size_t i = part.number - 1; i < request_.points.size(); i += part.of) {
    SOMATO_TRY(const auto found, found_at(i));
    if (!found) missing.push_back(i);
  }
  return missing;
}

Result<void> SweepRun::run_point(std::size_t number, SweepProgress& progress) {
  SOMATO_TRY_VOID(use_point(number));
  const SweepPoint& point = request_.points[number];
  SOMATO_TRY(const auto plan, plan_of_point(request_.sweep, point));
  for (std::size_t i = 0; i < plan.parts.size(); ++i) {
    progress.begin_study(i, plan.parts.size());
    auto ran = run_study_at(point, plan.parts[i], progress);
    if (!ran) return ran;
  }
  return request_.targets ? remove_recordings(plan.parts) : Result<void>();
}

Result<void> SweepRun::remove_recordings(const std::vector<ReproductionPart>& parts) {
  for (const ReproductionPart& part : parts) SOMATO_TRY_VOID(recordings_.remove_explored(part));
  return {};
}

Result<void> SweepRun::run_study_at(const SweepPoint& point, const ReproductionPart& part,
                                    const SweepProgress& progress) {
  SOMATO_TRY(const auto name, name_of(part));
  SOMATO_TRY(const auto known, kept_.find(name));
  if (known) return {};
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
