#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "base/files/toml_file.h"
#include "base/support/places.h"
#include "somato/graph/module.h"
#include "somato/graph/system_description.h"
#include "somato/studies/own_systems.h"
#include "systems/graph/graph_json.h"

namespace somato {
namespace {

using Keys = std::set<std::string>;
using Texts = std::vector<std::string>;

constexpr const char* kMark = "not given in the paper";

// The entries of the list for one system.
struct PaperList {
  std::map<std::string, Value> given;
  std::map<std::string, Value> neurons;  ///< By the module's name.
  std::map<std::string, Value> items;
  Keys free;
  Keys unused;
};

// A key as it stands in a file.
struct WrittenKey {
  Value value;
  std::size_t line = 0;  ///< From 1.
  bool marked = false;   ///< Whether the line says that no paper gives it.
};
using WrittenKeys = std::map<std::string, WrittenKey>;

std::size_t line_of(const std::string& where) {
  return std::stoul(where.substr(where.rfind(':') + 1));
}

// All values in a table by their full keys; the tables of a list have numbers from 1.
void for_each_value(const Table& table, const std::string& prefix,
                    const std::function<void(const std::string&, const Table::Entry&)>& visit) {
  for (const Table::Entry& entry : table.entries) {
    const std::string key = prefix + entry.name;
    if (std::holds_alternative<Value>(entry.content)) visit(key, entry);
    if (const auto* inner = std::get_if<Table>(&entry.content)) {
      for_each_value(*inner, key + ".", visit);
    }
    if (const auto* list = std::get_if<std::vector<Table>>(&entry.content)) {
      for (std::size_t i = 0; i < list->size(); ++i) {
        for_each_value((*list)[i], key + "." + std::to_string(i + 1) + ".", visit);
      }
    }
  }
}

Texts texts_of(const Table& table, const std::string& key) {
  Texts texts;
  for (const Value& value :
       std::get<Value::List>(std::get<Value>(table.find(key)->content).content)) {
    texts.push_back(std::get<std::string>(value.content));
  }
  return texts;
}

void add_section(const Table& section, PaperList& list) {
  for (const Table::Entry& part : section.entries) {
    if (part.name == "section" || part.name == "systems") continue;
    auto* into = part.name == "given"     ? &list.given
                 : part.name == "neurons" ? &list.neurons
                 : part.name == "items"   ? &list.items
                                          : nullptr;
    ASSERT_NE(into, nullptr) << part.where << ": " << part.name;
    for_each_value(std::get<Table>(part.content), "",
                   [&](const std::string& key, const Table::Entry& entry) {
                     EXPECT_TRUE(into->emplace(key, std::get<Value>(entry.content)).second)
                         << entry.where << ": " << key << " is given twice";
                   });
  }
}

PaperList paper_list(const std::string& system) {
  const auto file = read_toml(source_path("tests/studies/run/given_by_papers.toml"));
  PaperList list;
  for (const Table::Entry& kind : file.value().entries) {
    for (const Table& table : std::get<std::vector<Table>>(kind.content)) {
      const Texts systems = texts_of(table, "systems");
      if (std::find(systems.begin(), systems.end(), system) == systems.end()) continue;
      if (kind.name != "free" && kind.name != "unused") {
        add_section(table, list);
        continue;
      }
      for (const std::string& key : texts_of(table, "keys")) {
        (kind.name == "free" ? list.free : list.unused).insert(key);
      }
    }
  }
  return list;
}

Texts split_lines(const std::string& text) {
  std::istringstream stream(text);
  Texts lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const Texts& lines) {
  return std::accumulate(
      lines.begin(), lines.end(), std::string(),
      [](const std::string& all, const std::string& line) { return all + line + "\n"; });
}

// The settings that decide results: how things are explored, modules and phases.
bool is_setting(const std::string& key) {
  return key.starts_with("explore.") || key.starts_with("module.") || key.starts_with("phase.");
}

WrittenKeys written_keys(const Texts& lines, const Table& file) {
  WrittenKeys keys;
  for_each_value(file, "", [&](const std::string& key, const Table::Entry& entry) {
    if (!is_setting(key)) return;
    const std::size_t line = line_of(entry.where);
    const bool marked = lines.at(line - 1).find(kMark) != std::string::npos;
    keys[key] = {std::get<Value>(entry.content), line, marked};
  });
  return keys;
}

// The connections of modules, and the channels that are read.
bool is_connection(const std::string& key) {
  static const Keys kNames{"type", "input", "inputs", "channel", "shape", "learn"};
  return kNames.contains(key.substr(key.rfind('.') + 1));
}

// The free parameters, from the list and from what the program says of its parameters.
Keys free_keys(const Table& file, const PaperList& list) {
  Keys keys = list.free;
  const auto add = [&](const std::string& table, const ParameterInfo& info) {
    const std::string key = table + "." + info.name;
    const bool settled = list.given.contains(key) || list.unused.contains(key);
    if (!settled && detail::is_not_given(info)) keys.insert(key);
  };
  const SystemDescription system =
      read_system(file, {"study", "explore", "variation", "claim"}).value();
  for (const ModuleDescription& module : system.modules) {
    const Value& type = std::get<Value>(module.settings.find("type")->content);
    for (const ParameterInfo& info :
         find_module_type(std::get<std::string>(type.content), {}).value()->parameters) {
      add("module." + module.name, info);
    }
  }
  for (std::size_t i = 1; i <= system.phases.size(); ++i) {
    for (const auto& parameter : PhaseDescription::declarations().all()) {
      add("phase." + std::to_string(i), parameter.info);
    }
  }
  return keys;
}

std::int64_t integer_of(const Value& value) {
  return std::get<std::int64_t>(value.content);
}

std::int64_t neurons_of(const WrittenKeys& keys, const std::string& module) {
  std::int64_t neurons = 1;
  for (const char* key : {"rows", "columns", "shape"}) {
    const auto found = keys.find("module." + module + "." + key);
    if (found == keys.end()) continue;
    const Value& value = found->second.value;
    const auto* list = std::get_if<Value::List>(&value.content);
    for (const Value& length : list ? *list : Value::List{value}) neurons *= integer_of(length);
  }
  return neurons;
}

// The errors in the text of a system.
class Complaints {
 public:
  Complaints(const std::string& text, const PaperList& list)
      : list_(list),
        lines_(split_lines(text)),
        file_(parse_toml(text, "system").value()),
        keys_(written_keys(lines_, file_)) {
    check_given();
    check_free();
    check_others();
  }

  const Texts& all() const { return all_; }

 private:
  void complain(const std::string& key, const std::string& what) {
    all_.push_back(key + ": " + what);
  }

  const WrittenKey* find(const std::string& key) {
    const auto found = keys_.find(key);
    if (found != keys_.end()) return &found->second;
    complain(key, "is not there");
    return nullptr;
  }

  void check_given() {
    for (const auto& [key, value] : list_.given) {
      const WrittenKey* written = find(key);
      if (!written) continue;
      if (written->value != value) complain(key, "the paper gives " + to_toml(value));
      if (written->marked) complain(key, "is given");
    }
    for (const auto& [module, count] : list_.neurons) {
      if (neurons_of(keys_, module) != integer_of(count)) {
        complain(module, "the paper gives " + to_toml(count) + " neurons");
      }
    }
    for (const auto& [key, count] : list_.items) {
      const WrittenKey* written = find(key);
      if (!written) continue;
      const auto& values = std::get<Value::List>(written->value.content);
      if (static_cast<std::int64_t>(values.size()) != integer_of(count)) {
        complain(key, "the paper gives " + to_toml(count));
      }
    }
  }

  void check_free() {
    for (const std::string& key : free_keys(file_, list_)) {
      const WrittenKey* written = find(key);
      if (written && !written->marked) complain(key, std::string("does not say ") + kMark);
    }
    for (const std::string& key : list_.unused) {
      if (keys_.contains(key)) complain(key, "has no effect");
    }
  }

  void check_others() {
    for (const auto& [key, written] : keys_) {
      if (written.marked || list_.given.contains(key) || is_connection(key)) continue;
      complain(key, std::string("is neither in the list nor ") + kMark);
    }
  }

  const PaperList& list_;
  Texts lines_;
  Table file_;
  WrittenKeys keys_;
  Texts all_;
};

// Calls `check` with the text and the list of each of the nine.
void for_each_system(const std::function<void(const std::string&, const PaperList&)>& check) {
  const OwnSystems own = own_systems().value();
  for (const NamedFile& file : own.systems) {
    SCOPED_TRACE(file.name);
    check(std::string(find_own_file(file.name).value().text), paper_list(file.name));
  }
}

TEST(OwnSystemsGiven, EverySystemSaysWhatIsGivenAndWhatIsNot) {
  for_each_system([](const std::string& text, const PaperList& list) {
    EXPECT_FALSE(list.given.empty());
    const Complaints complaints(text, list);
    for (const std::string& complaint : complaints.all()) ADD_FAILURE() << complaint;
  });
}

// With the lines of all keys that are given (or of all that are not) changed by `edit`, each of
// these keys is complained of as `what`.
void expect_found(const std::string& text, const PaperList& list, bool marked,
                  const std::function<std::string(const std::string&)>& edit,
                  const std::string& what) {
  Texts lines = split_lines(text);
  Texts expected;
  for (const auto& [key, written] : written_keys(lines, parse_toml(text, "system").value())) {
    if (marked ? !written.marked : !list.given.contains(key)) continue;
    lines[written.line - 1] = edit(lines[written.line - 1]);
    expected.push_back(key + ": " + what);
  }
  const Complaints complaints(joined(lines), list);
  for (const std::string& complaint : expected) {
    EXPECT_GE(std::count(complaints.all().begin(), complaints.all().end(), complaint), 1)
        << complaint;
  }
}

TEST(OwnSystemsGiven, NoKeyMayBeMissing) {
  for_each_system([](const std::string& text, const PaperList& list) {
    const auto nothing = [](const std::string& /*line*/) { return std::string(); };
    expect_found(text, list, true, nothing, "is not there");
    expect_found(text, list, false, nothing, "is not there");
  });
}

TEST(OwnSystemsGiven, NoCommentMayBeMissingOrWrong) {
  for_each_system([](const std::string& text, const PaperList& list) {
    const auto bare = [](const std::string& line) { return line.substr(0, line.find("  #")); };
    const auto marked = [](const std::string& line) { return line + "  # " + kMark; };
    expect_found(text, list, true, bare, std::string("does not say ") + kMark);
    expect_found(text, list, false, marked, "is given");
  });
}

TEST(OwnSystemsGiven, AnotherValueThanThePapersIsFound) {
  PaperList list = paper_list("texture");
  const std::string text(find_own_file("texture").value().text);
  list.given["module.map.rows"] = Value{std::int64_t{14}};
  EXPECT_EQ(Complaints(text, list).all(), Texts{"module.map.rows: the paper gives 14"});
}

TEST(OwnSystemsGiven, AnotherNumberOfNeuronsOrValuesIsFound) {
  PaperList list = paper_list("t_mpsom_multiplied");
  const std::string text(find_own_file("t_mpsom_multiplied").value().text);
  list.neurons["felt"] = Value{std::int64_t{1057}};
  list.items["explore.plan.heights"] = Value{std::int64_t{3}};
  EXPECT_EQ(Complaints(text, list).all(), (Texts{"felt: the paper gives 1057 neurons",
                                                 "explore.plan.heights: the paper gives 3"}));
}

TEST(OwnSystemsGiven, WhatHasNoEffectIsNotWritten) {
  PaperList list = paper_list("texture");
  const std::string text(find_own_file("texture").value().text);
  list.unused.insert("module.spectrum.window");
  EXPECT_EQ(Complaints(text, list).all(), Texts{"module.spectrum.window: has no effect"});
}

}  // namespace
}  // namespace somato
