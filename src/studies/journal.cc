#include "studies/journal.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "somato/files/whole_file.h"

namespace somato {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;

tl::unexpected<Error> system_error(const std::string& path, const std::string& what) {
  return fail(ErrorKind::kSystem, what + ": " + std::strerror(errno), path,
              "give --out a folder that can be written to");
}

std::string header_of(const std::string& fingerprint) {
  return Json{{"somato_journal", kVersion}, {"study", fingerprint}}.dump() + "\n";
}

std::string line_of(std::size_t protocol, std::size_t training, const FoldOutcome& outcome) {
  return Json{{"protocol", protocol},
              {"training", training},
              {"winners", outcome.winners},
              {"predictions", outcome.predictions},
              {"raw_baseline", outcome.raw_baseline},
              {"standardized_baseline", outcome.standardized_baseline},
              {"summed_distance", outcome.summed_distance},
              {"torn", outcome.torn},
              {"apart", outcome.apart},
              {"connected", outcome.connected},
              {"connected_wrong", outcome.connected_wrong}}
             .dump() +
         "\n";
}

FoldOutcome outcome_of(const Json& line) {
  FoldOutcome outcome;
  line.at("winners").get_to(outcome.winners);
  line.at("predictions").get_to(outcome.predictions);
  line.at("raw_baseline").get_to(outcome.raw_baseline);
  line.at("standardized_baseline").get_to(outcome.standardized_baseline);
  line.at("summed_distance").get_to(outcome.summed_distance);
  line.at("torn").get_to(outcome.torn);
  line.at("apart").get_to(outcome.apart);
  line.at("connected").get_to(outcome.connected);
  line.at("connected_wrong").get_to(outcome.connected_wrong);
  return outcome;
}

// The whole lines of a text, one after the other; what follows the last of them is left out.
class Lines {
 public:
  explicit Lines(std::string_view text) : left_(text) {}

  std::optional<std::string_view> next() {
    const std::size_t end = left_.find('\n');
    if (end == std::string_view::npos) return {};
    const std::string_view line = left_.substr(0, end);
    left_.remove_prefix(end + 1);
    return line;
  }
  std::size_t left() const { return left_.size(); }

 private:
  std::string_view left_;
};

tl::unexpected<Error> damaged(const std::string& path) {
  return fail(ErrorKind::kData, "the file is no journal of a study, or damaged", path,
              "remove it to begin the study anew");
}

}  // namespace

Result<Journal> Journal::open(const std::string& path, const std::string& fingerprint) {
  Journal journal;
  journal.path_ = path;
  std::string text;
  std::error_code code;
  if (std::filesystem::exists(path, code)) {
    auto read = read_whole(path);
    if (!read) return fail(std::move(read.error()));
    text = std::move(*read);
  }
  Lines lines(text);
  const auto header = lines.next();
  if (header && std::string(*header) + "\n" != header_of(fingerprint)) {
    const Json parsed = Json::parse(*header, nullptr, false);
    if (!parsed.is_object() || !parsed.contains("somato_journal")) return damaged(path);
    return fail(ErrorKind::kUsage,
                "the folder holds an interrupted study with other settings or data", path,
                "run that one to its end, give another --out, or remove the file");
  }
  while (const auto line = lines.next()) {
    try {
      const Json parsed = Json::parse(*line);
      journal.known_[{parsed.at("protocol"), parsed.at("training")}] = outcome_of(parsed);
    } catch (const Json::exception&) {
      return damaged(path);
    }
  }
  // A line that was cut must not become the beginning of the next one.
  const std::string whole =
      header ? text.substr(0, text.size() - lines.left()) : header_of(fingerprint);
  if (whole != text) {
    if (auto saved = save_whole(path, whole); !saved) return fail(std::move(saved.error()));
  }
  journal.file_.reset(std::fopen(path.c_str(), "ab"));
  if (!journal.file_) return system_error(path, "the journal cannot be opened");
  return journal;
}

const FoldOutcome* Journal::find(std::size_t protocol, std::size_t training) const {
  const auto found = known_.find({protocol, training});
  return found == known_.end() ? nullptr : &found->second;
}

Result<void> Journal::add(std::size_t protocol, std::size_t training, const FoldOutcome& outcome) {
  if (!file_) return {};
  const std::string line = line_of(protocol, training, outcome);
  const std::lock_guard lock(*mutex_);
  const bool written = std::fwrite(line.data(), 1, line.size(), file_.get()) == line.size() &&
                       std::fflush(file_.get()) == 0;
  if (!written) return system_error(path_, "the journal cannot be written");
  return {};
}

}  // namespace somato
