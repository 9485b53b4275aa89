#include "studies/run/journal.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "base/archives/checksum.h"
#include "base/files/whole_file.h"
#include "base/text/flag_hint.h"
#include "base/text/format_version.h"
#include "studies/run/checked_line.h"
#include "systems/graph/graph_json.h"

namespace somato {
namespace {

using SortedJson = nlohmann::json;

constexpr std::uint64_t kJournalVersion = 8;

tl::unexpected<Error> system_error(const std::string& path, const std::string& what) {
  return fail(ErrorKind::kSystem, what + ": " + std::strerror(errno), path,
              "choose a writable folder" + flag_hint("out"));
}

std::string header_of(const std::string& fingerprint) {
  return checked_line({{"somato_journal", kJournalVersion}, {"study", fingerprint}});
}

// Different studies have different names, so that a folder can hold the journals of several.
std::string part_name(const std::string& fingerprint) {
  return checksum_name(header_of(fingerprint)) + ".journal";
}

template <typename T>
concept HasFields = requires(T& value) { T::fields(value, [](const char*, auto&) {}); };

// A line has a checksum, so that its grid is possible.
Grid grid_of(const SortedJson& json) {
  const auto columns = json.at("columns").get<std::size_t>();
  if (json.contains("edges")) {
    return Grid(std::make_shared<const NeuronGraph>(
        columns, json.at("edges").get<std::vector<NeuronGraph::Edge>>()));
  }
  return {json.at("rows").get<std::size_t>(), columns,
          choice_named<Lattice>("lattice", json.at("lattice").get<std::string>(), {}).value(),
          choice_named<Topology>("topology", json.at("topology").get<std::string>(), {}).value()};
}

template <typename T>
SortedJson outcome_json(const T& value) {
  if constexpr (std::is_same_v<T, Grid>) {
    return detail::grid_json(value);
  } else if constexpr (HasFields<T>) {
    // Fields with their initial values, such as those of other protocols, are left out.
    SortedJson json = SortedJson::object();
    T::fields(value, [&]<typename Field>(const char* name, const Field& field) {
      if (field != Field{}) json[name] = outcome_json(field);
    });
    return json;
  } else if constexpr (requires { requires HasFields<typename T::value_type>; }) {
    SortedJson list = SortedJson::array();
    for (const auto& one : value) list.push_back(outcome_json(one));
    return list;
  } else {
    return value;
  }
}

template <typename T>
void read_outcome(const SortedJson& json, T& value) {
  if constexpr (std::is_same_v<T, Grid>) {
    value = grid_of(json);
  } else if constexpr (HasFields<T>) {
    T::fields(value, [&](const char* name, auto& field) {
      if (json.contains(name)) read_outcome(json.at(name), field);
    });
  } else if constexpr (requires { requires HasFields<typename T::value_type>; }) {
    for (const SortedJson& one : json) read_outcome(one, value.emplace_back());
  } else {
    json.get_to(value);
  }
}

SortedJson content_for(std::size_t protocol, std::size_t training, const FoldOutcome& outcome) {
  SortedJson content = outcome_json(outcome);
  content["protocol"] = protocol;
  content["training"] = training;
  return content;
}

// The complete lines of a text, one after the other; text after the last one is omitted.
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

// The version in the first line of a journal, which had no checksum in the first version; 0 if it
// is not that of a journal.
std::uint64_t version_of(std::string_view header) {
  auto content = checked_content(header);
  if (!content) content = SortedJson::parse(header, nullptr, false);
  const auto version = content->is_object() ? content->find("somato_journal") : content->end();
  return version != content->end() && version->is_number_unsigned() ? version->get<std::uint64_t>()
                                                                    : 0;
}

std::string how_to_continue(const std::string& study) {
  return fmt::format("complete that study{}, use another folder{}, or remove the file", study,
                     flag_hint("out"));
}

tl::unexpected<Error> damaged(const std::string& path) {
  return fail(ErrorKind::kData, "the file is damaged, or not a journal of a study", path,
              "remove it to restart the study");
}

}  // namespace

Result<Journal> Journal::open(const std::string& path, const std::string& fingerprint) {
  Journal journal;
  journal.path_ = path;
  journal.header_ = header_of(fingerprint);
  std::error_code code;
  // The first version of the format had another name.
  const auto first = std::filesystem::path(path).replace_extension(".jsonl").string();
  for (const std::string& known : {path, first}) {
    if (!std::filesystem::exists(known, code)) continue;
    journal.path_ = known;
    SOMATO_TRY(const auto text, read_whole(known));
    SOMATO_TRY_VOID(journal.read(text));
  }
  journal.path_ = path;
  return journal;
}

Result<Journal> Journal::open_part(const std::filesystem::path& own,
                                   const std::string& fingerprint) {
  return open((own / part_name(fingerprint)).string(), fingerprint);
}

Result<void> Journal::read(const std::string& text) {
  Lines lines(text);
  const auto header = lines.next();
  if (!header) return header_.starts_with(text) ? Result<void>() : damaged(path_);
  if (std::string(*header) + "\n" != header_) {
    const std::uint64_t version = version_of(*header);
    if (version == 0) return damaged(path_);
    if (version != kJournalVersion) {
      return unsupported_format(version, kJournalVersion, path_,
                                how_to_continue(" with that version"));
    }
    return fail(ErrorKind::kUsage,
                "the folder contains an interrupted study with other settings or data", path_,
                how_to_continue(""));
  }
  whole_ = read_trainings(text);
  return {};
}

std::size_t Journal::read_trainings(const std::string& text) {
  Lines lines(std::string_view(text).substr(header_.size()));
  for (std::size_t left = lines.left();; left = lines.left()) {
    const auto line = lines.next();
    const auto content = line ? checked_content(*line) : std::nullopt;
    if (!content) return text.size() - left;  // trainings after a damaged line are computed again
    FoldOutcome outcome;
    read_outcome(*content, outcome);
    known_[{content->at("protocol"), content->at("training")}] = std::move(outcome);
  }
}

void Journal::look(const std::filesystem::path& parts, const std::string& fingerprint) {
  header_ = header_of(fingerprint);
  std::error_code ignored;
  for (const auto& part : std::filesystem::directory_iterator(parts, ignored)) {
    const auto text = read_whole((part.path() / part_name(fingerprint)).string());
    if (text && text->starts_with(header_)) read_trainings(*text);
  }
}

const FoldOutcome* Journal::find(std::size_t protocol, std::size_t training) const {
  const auto found = known_.find({protocol, training});
  return found == known_.end() ? nullptr : &found->second;
}

Result<void> Journal::add(std::size_t protocol, std::size_t training, const FoldOutcome& outcome) {
  if (path_.empty()) return {};
  const std::string line = checked_line(content_for(protocol, training, outcome));
  const std::scoped_lock lock(*mutex_);
  if (!file_) {
    // A line that was cut must not become the beginning of the next one.
    std::error_code code;
    if (whole_ > 0) std::filesystem::resize_file(path_, whole_, code);
    if (!code) file_.reset(std::fopen(path_.c_str(), whole_ > 0 ? "ab" : "wb"));
    if (!file_) return system_error(path_, "the journal cannot be opened");
    if (whole_ == 0 && !write(header_)) return system_error(path_, "the journal cannot be written");
  }
  if (!write(line)) return system_error(path_, "the journal cannot be written");
  return {};
}

bool Journal::write(const std::string& line) {
  return std::fwrite(line.data(), 1, line.size(), file_.get()) == line.size() &&
         std::fflush(file_.get()) == 0;
}

}  // namespace somato
