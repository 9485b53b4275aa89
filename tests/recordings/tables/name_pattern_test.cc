#include "recordings/tables/name_pattern.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace somato {
namespace {

// "fabric=Linen force=120", or what is wrong, or "no".
std::string reading(const char* pattern, const char* path) {
  const auto labels = NamePattern::parse(pattern).value().match(path);
  if (!labels) return labels.error().what;
  if (!*labels) return "no";
  std::string text;
  for (const Label& label : **labels) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", label.name, label.value);
  }
  return text;
}

std::string refusal(const char* pattern) {
  const auto parsed = NamePattern::parse(pattern);
  if (parsed) return "none";
  EXPECT_EQ(parsed.error().kind, ErrorKind::kUsage);
  return parsed.error().what;
}

TEST(NamePattern, ReadsLabels) {
  EXPECT_EQ(reading("{fabric}_F{force}_{trial}.csv", "Linen_F120_0.csv"),
            "fabric=Linen force=120 trial=0");
  EXPECT_EQ(reading("a{x}", "abc"), "x=bc");
  EXPECT_EQ(reading("{x}", "a.b c"), "x=a.b c");
}

TEST(NamePattern, FitsWholeNamesOnly) {
  for (const char* name : {"", "a.csv", "_1.csv", "a_.csv", "a_1.csv~", "a_1.CSV", "a_1"}) {
    EXPECT_EQ(reading("{a}_{b}.csv", name), "no") << name;
  }
  EXPECT_EQ(reading("raw_{a}.csv", "a.csv"), "no");
  EXPECT_EQ(reading("{a}.csv", ".csv"), "no");
}

TEST(NamePattern, NarrowsALabelToNumbers) {
  EXPECT_EQ(reading("{object}_{trial:number}.txt", "blue_bear_12.txt"),
            "object=blue_bear trial=12");
  EXPECT_EQ(reading("V{v:number}", "V-0.25"), "v=-0.25");
  EXPECT_EQ(reading("V{v:number}", "V+3"), "v=+3");
  for (const char* name : {"V", "V-", "V1.", "V.5", "V1e3", "Vx", "V1.2.3", "V--1", "V 1"}) {
    EXPECT_EQ(reading("V{v:number}", name), "no") << name;
  }
}

TEST(NamePattern, RefusesANameWithTwoReadings) {
  EXPECT_EQ(reading("{object}_{trial}.csv", "blue_bear_1.csv"),
            "the name can be read in more than one way: object = 'blue', trial = 'bear_1'; or "
            "object = 'blue_bear', trial = '1'");
}

TEST(NamePattern, TakesLabelsFromFolders) {
  EXPECT_EQ(reading("{material}/{trial}.csv", "wood/1.csv"), "material=wood trial=1");
  EXPECT_EQ(reading("{material}/{trial}.csv", "day 2/wood/1.csv"), "material=wood trial=1");
  EXPECT_EQ(reading("{material}/{trial}.csv", "1.csv"), "no");
  EXPECT_EQ(reading("{trial}.csv", "day 2/wood/1.csv"), "trial=1");
  EXPECT_EQ(reading("raw/{trial}.csv", "raw/1.csv"), "trial=1");
  EXPECT_EQ(reading("raw/{trial}.csv", "1.csv"), "no");
}

TEST(NamePattern, RefusesAWrongPattern) {
  EXPECT_EQ(refusal("all.csv"), "the pattern has no labels");
  EXPECT_EQ(refusal(""), "the pattern has no labels");
  EXPECT_EQ(refusal("{a}{b}.csv"),
            "two labels of the pattern are adjacent, so that their boundary is undefined");
  EXPECT_EQ(refusal("{a}_{a}"), "two labels are named 'a'");
  EXPECT_EQ(refusal("{}_1"), "a label of the pattern has no name");
  EXPECT_EQ(refusal("{:number}_1"), "a label of the pattern has no name");
  EXPECT_EQ(refusal("{a:text}"), "a label cannot be restricted to 'text', only to 'number'");
  EXPECT_EQ(refusal("{a:}"), "a label cannot be restricted to '', only to 'number'");
  for (const char* pattern : {"{a", "a}", "{a}_}", "{a{b}}", "{a}_{"}) {
    EXPECT_EQ(refusal(pattern), "a brace of the pattern has no counterpart") << pattern;
  }
}

TEST(NamePattern, MayBeWithoutLabels) {
  const NamePattern pattern = NamePattern::parse("day.1/all.csv", false).value();
  EXPECT_EQ(pattern.labels(), std::vector<std::string>{});
  EXPECT_EQ(pattern.extension(), ".csv");
  EXPECT_EQ(pattern.match("here/day.1/all.csv").value(), std::vector<Label>{});
  EXPECT_EQ(pattern.match("day.1/all.csv2").value(), std::nullopt);
  EXPECT_EQ(pattern.match("all.csv").value(), std::nullopt);
  EXPECT_EQ(NamePattern::parse("a}", false).error().what,
            "a brace of the pattern has no counterpart");
}

TEST(NamePattern, KnowsItsLabelsAndExtension) {
  const NamePattern pattern = NamePattern::parse("a.b/{x}_{y}.raw.csv").value();
  EXPECT_EQ(pattern.labels(), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(pattern.extension(), ".csv");
  EXPECT_EQ(NamePattern::parse("{x}")->extension(), "");
  EXPECT_EQ(NamePattern::parse("a.{x}")->extension(), "");
}

// Every way to cut `name` into non-empty values with `separators` between them.
std::set<std::vector<std::string>> all_cuts(const std::string& name,
                                            const std::vector<std::string>& separators) {
  if (separators.empty()) {
    return name.empty() ? std::set<std::vector<std::string>>{}
                        : std::set<std::vector<std::string>>{{name}};
  }
  std::set<std::vector<std::string>> cuts;
  const std::vector<std::string> rest(separators.begin() + 1, separators.end());
  for (std::size_t end = 1; end <= name.size(); ++end) {
    if (name.compare(end, separators[0].size(), separators[0]) != 0) continue;
    for (std::vector<std::string> cut : all_cuts(name.substr(end + separators[0].size()), rest)) {
      cut.insert(cut.begin(), name.substr(0, end));
      cuts.insert(cut);
    }
  }
  return cuts;
}

// Every text of `least` to `most` letters 'a' and '_'.
std::vector<std::string> all_texts(std::size_t least, std::size_t most) {
  std::vector<std::string> texts;
  for (std::size_t size = least; size <= most; ++size) {
    for (std::size_t bits = 0; bits < std::size_t{1} << size; ++bits) {
      std::string text;
      for (std::size_t i = 0; i < size; ++i) text += (bits >> i) % 2 == 0 ? 'a' : '_';
      texts.push_back(text);
    }
  }
  return texts;
}

void expect_as_every_cut(const std::vector<std::string>& separators) {
  std::string pattern = "{0}";
  for (std::size_t i = 0; i < separators.size(); ++i) {
    pattern += separators[i] + fmt::format("{{{}}}", i + 1);
  }
  const NamePattern parsed = NamePattern::parse(pattern).value();
  for (const std::string& name : all_texts(0, 8)) {
    const auto cuts = all_cuts(name, separators);
    const auto labels = parsed.match(name);
    ASSERT_EQ(labels.has_value(), cuts.size() < 2) << pattern << " of " << name;
    if (!labels) continue;
    ASSERT_EQ(labels->has_value(), cuts.size() == 1) << pattern << " of " << name;
    for (std::size_t i = 0; *labels && i < (**labels).size(); ++i) {
      ASSERT_EQ((**labels)[i].value, (*cuts.begin())[i]) << pattern << " of " << name;
    }
  }
}

TEST(NamePattern, ReadsWhatTryingEveryCutReads) {
  expect_as_every_cut({});
  for (const std::string& first : all_texts(1, 2)) {
    expect_as_every_cut({first});
    for (const std::string& second : all_texts(1, 2)) expect_as_every_cut({first, second});
  }
}

}  // namespace
}  // namespace somato
