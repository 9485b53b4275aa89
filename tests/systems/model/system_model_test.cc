#include "somato/graph/system_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/archives/archive.h"
#include "base/support/damaged_files.h"
#include "maps/support/saved_maps.h"
#include "somato/core/check.h"
#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::build;
using testing::dense;
using testing::hand_recording;
using testing::output_of;
using testing::trained;
using testing::try_build;
using testing::with_part;
using testing::without_part;

// One of each that learns.
const std::string kModelText =
    "[system]\nname = \"all\"\n"
    "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n"
    "[module.height]\ntype = \"channel\"\nchannel = \"height\"\n"
    "[module.standard]\ntype = \"standardization\"\ninput = \"joints\"\n"
    "[module.code]\ntype = \"one_hot\"\ninput = \"height\"\nelements = 2\noutside = \"clamp\"\n"
    "[module.tensor]\ntype = \"t_mpsom\"\ninputs = [\"code\", \"standard\"]\nshape = [2, 2]\n"
    "[module.stm]\ntype = \"accumulate\"\ninput = \"tensor\"\n"
    "[module.map]\ntype = \"som\"\ninput = \"stm\"\nrows = 1\ncolumns = 2\niterations = 20\n"
    "[[phase]]\nlearn = \"tensor\"\ndraws = 30\n";

System small_system() {
  const Recording recording = hand_recording(4, 8);
  return trained(build(kModelText, recording), recording, 3);
}

SystemAnswer small_answer() {
  return {"map", "object", {"ball", "a \"cube\""}, NeuronLabels({std::nullopt, 1})};
}

SystemAnswer wary_answer() {
  SystemAnswer answer = small_answer();
  answer.novelty = Novelty{0.1, 23, 1.0 / 3.0, {0.1, 2.5}};
  return answer;
}

TEST(SystemModel, KeepsTheThresholdForUnknownInputs) {
  const TemporaryFolder folder;
  ASSERT_TRUE(save_system(folder.file("a"), small_system(), wary_answer()));
  const auto loaded = load_system(folder.file("a"));
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_EQ(loaded->answer->novelty, wary_answer().novelty);
  ASSERT_TRUE(save_system(folder.file("b"), loaded->system, loaded->answer));
  EXPECT_EQ(bytes_of(folder.file("b")), bytes_of(folder.file("a")));
}

SystemAnswer whitening_answer() {
  SystemAnswer answer = wary_answer();
  const std::size_t elements =
      som_of(small_system(), small_system().modules().size() - 1)->input_size();
  answer.novelty->whitening = Matrix<double>(elements, elements, 1.0 / 3.0);
  return answer;
}

TEST(SystemModel, KeepsTheWhiteningForUnknownInputs) {
  const TemporaryFolder folder;
  ASSERT_TRUE(save_system(folder.file("a"), small_system(), whitening_answer()));
  const auto loaded = load_system(folder.file("a"));
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_EQ(loaded->answer->novelty, whitening_answer().novelty);
}

TEST(SystemModel, KeepsHowTheTableOfItsTrainingWasRead) {
  const TemporaryFolder folder;
  SystemModel model{small_system(), small_answer()};
  model.recording = {.label_column = "kind",
                     .columns_to_use = {"t*"},
                     .skip = {"t7", "a,b"},
                     .missing = MissingValues::kMask,
                     .decimal = DecimalMark::kComma,
                     .header = true};
  ASSERT_TRUE(save_system(folder.file("a"), model));
  const auto loaded = load_system(folder.file("a"));
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_EQ(loaded->recording, model.recording);
  EXPECT_EQ(copy_of(*loaded).recording, model.recording);
  ASSERT_TRUE(save_system(folder.file("b"), *loaded));
  EXPECT_EQ(bytes_of(folder.file("b")), bytes_of(folder.file("a")));
}

TEST(SystemModel, IsTheSameWhenLoaded) {
  const TemporaryFolder folder;
  const Recording recording = hand_recording(6, 8);
  const System system = trained(build(kModelText, recording), recording, 3);
  for (const bool answers : {false, true}) {
    const auto answer = answers ? std::optional(small_answer()) : std::nullopt;
    ASSERT_TRUE(save_system(folder.file("a"), system, answer));
    const auto loaded = load_system(folder.file("a"));
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    ASSERT_EQ(loaded->answer.has_value(), answers);
    if (answers) {
      EXPECT_EQ(loaded->answer->map, "map");
      EXPECT_EQ(loaded->answer->label, "object");
      EXPECT_EQ(loaded->answer->classes, small_answer().classes);
      EXPECT_EQ(loaded->answer->labels, small_answer().labels);
    }
    EXPECT_EQ(loaded->system.description().name, "all");
    EXPECT_EQ(loaded->system.layout().channels, system.layout().channels);
    for (const SystemModule& module : system.modules()) {
      for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(dense(output_of(loaded->system, recording, module.name, i)),
                  dense(output_of(system, recording, module.name, i)))
            << module.name;
      }
    }
    ASSERT_TRUE(save_system(folder.file("b"), loaded->system, loaded->answer));
    EXPECT_EQ(bytes_of(folder.file("b")), bytes_of(folder.file("a")));
  }
}

TEST(SystemModel, MapsAreThoseOfTypeSom) {
  const System system = small_system();
  for (std::size_t i = 0; i < system.modules().size(); ++i) {
    EXPECT_EQ(som_of(system, i) != nullptr, system.modules()[i].name == "map");
  }
}

TEST(SystemModel, RefusesToSaveWhatCouldNotBeLoaded) {
  const TemporaryFolder folder;
  const System system = small_system();
  const auto refused = [&](const auto& spoil) {
    SystemAnswer answer = small_answer();
    spoil(answer);
    EXPECT_THROW((void)save_system(folder.file("a"), system, answer), InvalidArgument);
  };
  refused([](SystemAnswer& a) { a.map = "mapp"; });
  refused([](SystemAnswer& a) { a.map = "tensor"; });
  refused([](SystemAnswer& a) { a.labels = NeuronLabels({1}); });
  refused([](SystemAnswer& a) { a.labels = NeuronLabels({{}, {}}); });
  refused([](SystemAnswer& a) { a.labels = NeuronLabels({0, 2}); });
  refused([](SystemAnswer& a) { a.novelty = Novelty{0.1, 23, 1.0, {1.0}}; });
  refused([](SystemAnswer& a) {
    a.novelty = Novelty{0.1, 23, 1.0, {1.0, 1.0}, Matrix<double>(1, 1, 1.0)};
  });
  const Recording recording = hand_recording(4, 8);
  const std::string joints = "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n";
  for (const std::string type : {"standardization", "one_hot", "som"}) {
    const std::string text = joints + "[module.m]\ntype = \"" + type + "\"\ninput = \"joints\"\n";
    EXPECT_THROW((void)save_system(folder.file("a"), build(text, recording)), InvalidArgument);
    EXPECT_THROW((void)output_of(build(text, recording), recording, "m", 0), InvalidArgument);
  }
  const std::string text =
      joints + "[module.m]\ntype = \"t_mpsom\"\ninputs = \"joints\"\nshape = [2]\n";
  EXPECT_THROW((void)save_system(folder.file("a"), build(text, recording)), InvalidArgument);
  EXPECT_THROW((void)output_of(build(text, recording), recording, "m", 0), InvalidArgument);
  EXPECT_EQ(folder.count(), 0);
}

// A small file, because it is loaded once for every bit.
TEST(SystemModel, RefusesEveryTruncationAndEveryTurnedBit) {
  const TemporaryFolder folder;
  const std::string path = folder.file("model.somato");
  const Recording recording = hand_recording(3, 8);
  const System system = trained(build("[module.j]\ntype = \"channel\"\nchannel = \"height\"\n"
                                      "[module.s]\ntype = \"standardization\"\ninput = \"j\"\n",
                                      {recording}),
                                recording, 3);
  ASSERT_TRUE(save_system(path, system));
  testing::expect_damage_refused(path, load_system);
}

Archive saved_model() {
  const TemporaryFolder folder;
  EXPECT_TRUE(save_system(folder.file("a"), small_system(), whitening_answer()));
  return load_archive(folder.file("a")).value();
}

const Archive& an_archive() {
  static const Archive archive = saved_model();
  return archive;
}

// Saved with a checksum that is right.
void expect_model_refused(const Archive& archive, const std::string& because) {
  const TemporaryFolder folder;
  const std::string path = folder.file("hostile.somato");
  ASSERT_TRUE(save_archive(path, archive));
  const auto model = load_system(path);
  ASSERT_FALSE(model) << because;
  EXPECT_EQ(model.error().kind, ErrorKind::kData);
  EXPECT_TRUE(model.error().where.starts_with(path)) << to_string(model.error());
  EXPECT_NE(model.error().what.find(because), std::string::npos) << to_string(model.error());
}

// The archive with another content of a part.
Archive with_content(const std::string& name, const Archive::Content& content) {
  Archive changed(an_archive().kind());
  bool there = false;
  for (const Archive::Entry& entry : an_archive().entries()) {
    changed.add(entry.name, entry.name == name ? content : entry.content);
    there = there || entry.name == name;
  }
  EXPECT_TRUE(there) << name;
  return changed;
}

// In the place of the part, so that only the content differs.
void expect_model_part_refused(const std::string& name, const Archive::Content& content,
                               const std::string& because) {
  expect_model_refused(with_content(name, content), because);
}

// Files of versions before `tolerance` was added are read; what is written again has it.
TEST(SystemModel, ReadsParametersWithoutThoseThatWereAddedLater) {
  const std::string name = "module.map.parameters";
  const std::string whole = **an_archive().get<std::string>(name, "");
  const std::string line = "tolerance = 0.0\n";
  ASSERT_NE(whole.find(line), std::string::npos);
  std::string earlier = whole;
  earlier.erase(earlier.find(line), line.size());
  const TemporaryFolder folder;
  const std::string path = folder.file("earlier.somato");
  ASSERT_TRUE(save_archive(path, with_content(name, earlier)));
  const auto model = load_system(path);
  ASSERT_TRUE(model) << to_string(model.error());
  ASSERT_TRUE(save_system(path, *model));
  EXPECT_TRUE(load_archive(path).value() == an_archive());
  expect_model_part_refused(name, earlier + line, "do not fit together");
  expect_model_part_refused(name, whole + "\n\n", "do not fit together");
}

TEST(SystemModel, RefusesAnotherKindOfFile) {
  Archive other("som");
  for (const Archive::Entry& entry : an_archive().entries()) other.add(entry.name, entry.content);
  expect_model_refused(other, "the file contains 'som', not 'system'");
  expect_model_refused(Archive("system"), "'description' is missing");
}

TEST(SystemModel, RefusesPartsThatAreMissingOrTooMany) {
  for (const char* name :
       {"description", "layout", "module.standard.means", "module.standard.deviations",
        "module.code.low", "module.code.high", "module.tensor.parameters",
        "module.tensor.weights_0", "module.tensor.weights_1", "module.map.parameters",
        "module.map.weights", "labels", "novelty.scales"}) {
    expect_model_refused(without_part(an_archive(), name),
                         "'" + std::string(name) + "' is missing");
  }
  expect_model_refused(without_part(an_archive(), "answer"), "do not fit together");
  expect_model_refused(without_part(an_archive(), "novelty"), "do not fit together");
  for (const char* name : {"notes", "module.map.bias", "module.joints.means", "module.none.low"}) {
    expect_model_refused(with_part(an_archive(), name, std::string("x")), "do not fit together");
  }
}

TEST(SystemModel, RefusesDescriptionsAndLayoutsThatCannotBe) {
  const auto text_of = [](const char* part) { return **an_archive().get<std::string>(part, ""); };
  const std::string description = text_of("description");
  const std::string layout = text_of("layout");
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    return text.replace(text.find(from), from.size(), to);
  };
  expect_model_part_refused("description", std::string(), "no modules");
  expect_model_part_refused("description", std::string("["), "");
  expect_model_part_refused("description", Array<float>{{1}, {0}}, "another type");
  expect_model_part_refused("description", replaced(description, "\"accumulate\"", "\"accumulat\""),
                            "unknown type of module");
  expect_model_part_refused("description", replaced(description, "[2, 2]", "[2, 3]"),
                            "does not fit its module");
  expect_model_part_refused("description", replaced(description, "columns = 2", "columns = 3"),
                            "does not fit its module");
  expect_model_part_refused("description", description + "# a comment\n", "do not fit together");
  expect_model_part_refused("layout", std::string(), "its shape is unknown without a recording");
  expect_model_part_refused("layout", std::string("x = 1\n"), "the layout is invalid");
  expect_model_part_refused("layout", std::string("[channel]\n"), "the layout is invalid");
  expect_model_part_refused("layout", layout + "[[channel]]\nname = 3\n", "'name' must be");
  expect_model_part_refused("layout", replaced(layout, "shape = [3]", "shape = [4]"), "");
  expect_model_part_refused("layout", replaced(layout, "\"joints\"", "\"joint\""),
                            "unknown channel");
  expect_model_part_refused(
      "layout", replaced(layout, "shape = [3]", "shape = [9000000000000, 9000000000000]"),
      "exceeds the maximum of");
  expect_model_part_refused("layout", replaced(layout, "shape = [3]", "shape = []"), "");
}

TEST(SystemModel, RefusesWhatWasLearnedWhenItDoesNotFit) {
  using Numbers = std::vector<double>;
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  const auto one = [](double number) { return Array<double>{{1}, {number}}; };
  const auto three = [](Numbers numbers) { return Array<double>{{3}, std::move(numbers)}; };
  for (const double number : {nan, infinity}) {
    expect_model_part_refused("module.standard.means", three({0, number, 0}), "not finite");
    expect_model_part_refused("module.standard.deviations", three({1, number, 1}), "not finite");
    expect_model_part_refused("module.code.low", one(number), "for element 1");
    expect_model_part_refused("module.code.high", one(number), "for element 1");
  }
  expect_model_part_refused("module.standard.deviations", three({1, -1, 1}), "does not fit");
  expect_model_part_refused("module.standard.means", Array<double>{{2}, {0, 0}}, "does not fit");
  expect_model_part_refused("module.code.low", Array<double>{{2}, {0, 0}}, "do not fit");
  expect_model_part_refused("module.code.low", one(1e300), "for element 1");
  expect_model_part_refused("module.code.high", Array<float>{{1}, {1}}, "another type");
  expect_model_part_refused("module.map.weights", Array<float>{{2, 5}, std::vector<float>(10)},
                            "does not fit its module");
  expect_model_part_refused("module.map.weights", Array<float>{{3, 4}, std::vector<float>(12)},
                            "do not fit its grid");
  expect_model_part_refused("module.tensor.weights_0", Array<float>{{4, 3}, std::vector<float>(12)},
                            "are 4 x 3");
}

TEST(SystemModel, RefusesAnswersThatCannotBe) {
  using Labels = Array<std::int64_t>;
  const std::string classes = "label = \"object\"\nclasses = [\"ball\", \"cube\"]\n";
  expect_model_part_refused("answer", "map = \"mapp\"\n" + classes, "the output map is missing");
  expect_model_part_refused("answer", "map = \"stm\"\n" + classes, "the output map is missing");
  expect_model_part_refused("answer", "map = \"tensor\"\n" + classes, "the output map is missing");
  expect_model_part_refused("answer", std::string("map = \"map\"\nclasses = [\"ball\"]\n"),
                            "label of an unknown class");
  expect_model_part_refused("answer", std::string("map = 3\n"), "'map' must be");
  expect_model_part_refused("labels", Labels{{2}, {0, 2}}, "label of an unknown class");
  expect_model_part_refused("labels", Labels{{3}, {0, 1, 1}}, "do not fit the map");
  expect_model_part_refused("labels", Labels{{2}, {-1, -1}}, "no neuron has a label");
}

TEST(SystemModel, RefusesThresholdsThatCannotBe) {
  const auto text = [](const std::string& rate, const std::string& samples,
                       const std::string& threshold) {
    return "false_alarm_rate = " + rate + "\nsamples = " + samples + "\nthreshold = " + threshold +
           "\n";
  };
  const auto refused = [](Archive::Content content, const std::string& because) {
    expect_model_part_refused("novelty", std::move(content), because);
  };
  refused(text("1.5", "23", "1.0"), "'false_alarm_rate' must be");
  refused(text("0.1", "0", "1.0"), "'samples' must be");
  refused(text("0.1", "23", "0.0"), "'threshold' must be");
  refused(text("0.1", "23", "nan"), "'threshold' must be");
  refused(text("0.1", "23", "inf"), "'threshold' must be");
  refused(text("0.1", "23", "1.0") + "scale = 1.0\n", "unknown key 'scale'");
  refused(Array<double>{{1}, {1.0}}, "another type");
  const auto scales_refused = [](Archive::Content content, const std::string& because) {
    expect_model_part_refused("novelty.scales", std::move(content), because);
  };
  scales_refused(Array<double>{{1}, {1.0}}, "does not have a scale for each class");
  scales_refused(Array<double>{{2, 1}, {1.0, 1.0}}, "does not have a scale for each class");
  scales_refused(Array<float>{{2}, {1.0F, 1.0F}}, "another type");
  for (const double scale : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    scales_refused(Array<double>{{2}, {1.0, scale}}, "not above 0");
  }
  const std::size_t elements = whitening_answer().novelty->whitening.rows();
  std::vector<double> values(elements * elements, 1.0);
  expect_model_part_refused("novelty.whitening", Array<double>{{1, 1}, {1.0}}, "size of the map's");
  values.back() = std::nan("");
  expect_model_part_refused("novelty.whitening", Array<double>{{elements, elements}, values},
                            "not finite");
}

TEST(SystemModel, SaysWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  const auto model = load_system(folder.file("missing.somato"));
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().kind, ErrorKind::kSystem);
}

const std::string kJoints = "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n";
const std::string kLast = "[module.closed]\ntype = \"last\"\ninput = \"joints\"\n";

std::string automatic_map_of(const std::string& input, const std::string& more = "") {
  return "[module.map]\ntype = \"som\"\ninput = \"" + input +
         "\"\nrows = \"automatic\"\ncolumns = \"automatic\"\n" + more;
}

std::vector<std::size_t> shape_of_map(const System& system) {
  return system.modules().back().output.shape;
}

// 10 sqrt(16) = 40 neurons: 6 x 7.
TEST(AutomaticSize, FollowsTheExplorationsOrTheFrames) {
  const Recording recording = hand_recording(16, 1);
  const System of_explorations = build(kJoints + kLast + automatic_map_of("closed"), recording);
  EXPECT_EQ(shape_of_map(of_explorations), (std::vector<std::size_t>{6, 7}));
  const System of_frames = build(kJoints + automatic_map_of("joints"), recording);
  const std::size_t frames = layout_of(recording).frames;  // of sound, 16 to 20 an exploration
  SomParameters expected;
  expected.rows.reset();
  expected.columns.reset();
  decide_size(expected, frames);
  EXPECT_EQ(shape_of_map(of_frames), (std::vector<std::size_t>{*expected.rows, *expected.columns}));
  EXPECT_GT(*expected.rows * *expected.columns, 120U) << "10 sqrt(16 x 16) = 160";
}

TEST(AutomaticSize, IsKeptByWhatHasLearned) {
  const TemporaryFolder folder;
  const Recording recording = hand_recording(16, 1);
  for (const std::string& training : {std::string(), std::string("training = \"batch\"\n")}) {
    const System system = trained(
        build(kJoints + kLast + automatic_map_of("closed", training), recording), recording, 16);
    ASSERT_TRUE(save_system(folder.file("s"), system, std::nullopt));
    const auto loaded = load_system(folder.file("s"));
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    const auto elsewhere =
        System::build(loaded->system.description(), layout_of(hand_recording(3, 2)));
    ASSERT_TRUE(elsewhere) << to_string(elsewhere.error());
    EXPECT_EQ(shape_of_map(*elsewhere), (std::vector<std::size_t>{6, 7}));
  }
}

TEST(AutomaticSize, TakesARecording) {
  const auto built =
      try_build(kJoints + "shape = [3]\n" + kLast + automatic_map_of("closed"), Recording{});
  ASSERT_FALSE(built);
  EXPECT_EQ(built.error().kind, ErrorKind::kUsage);
  EXPECT_NE(
      to_string(built.error()).find("the map's size is automatic, which requires a recording"),
      std::string::npos)
      << to_string(built.error());
}

}  // namespace
}  // namespace somato
