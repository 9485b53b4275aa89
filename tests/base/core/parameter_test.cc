#include "somato/core/parameter.h"

#include <gtest/gtest.h>

#include "somato/core/check.h"

namespace somato {

enum class Shape { kPlane, kTorus };

template <>
struct Choices<Shape> {
  static const std::vector<std::pair<Shape, std::string>>& all() {
    static const std::vector<std::pair<Shape, std::string>> choices{{Shape::kPlane, "plane"},
                                                                    {Shape::kTorus, "torus"}};
    return choices;
  }
};

namespace {

struct Settings {
  std::uint32_t rows = 15;
  double learning_rate = 0.5;
  bool normalized = true;
  std::string title = "map";
  Shape topology = Shape::kPlane;
  std::optional<double> radius;
  std::vector<double> weights{1.0, 2.0};
  std::uint8_t channel = 0;

  static const Declarations<Settings>& declarations();
};

const Declarations<Settings>& Settings::declarations() {
  static const auto kAll =
      Declarations<Settings>()
          .add("rows", &Settings::rows, "neurons", Range::between(1, 1000), "Rows of the grid.")
          .add("learning_rate", &Settings::learning_rate, "", Range::above(0),
               "Share of the way to the sample.")
          .add("normalized", &Settings::normalized, "", Range::any(),
               "Whether weights keep the length 1.")
          .add("title", &Settings::title, "", Range::any(), "A name.")
          .add("topology", &Settings::topology, "", Range::any(), "How the borders meet.")
          .add("radius", &Settings::radius, "neurons", Range::at_least(0),
               "Radius of the neighbourhood; automatic: half the grid.")
          .add("weights", &Settings::weights, "", Range::at_least(0), "One an input.")
          .add("channel", &Settings::channel, "", Range::any(), "Name of the sensor.");
  return kAll;
}

Result<Settings> read_one(const std::string& name, Value value) {
  return read_parameters<Settings>(Table{"a.toml:1", {{name, "a.toml:2", std::move(value)}}});
}

// The failure's one line; empty when there was none.
std::string refusal(const std::string& name, Value value) {
  const Result<Settings> settings = read_one(name, std::move(value));
  if (settings) return {};
  EXPECT_EQ(settings.error().kind, ErrorKind::kUsage);
  return to_string(settings.error());
}

Value whole(std::int64_t number) {
  return {number};
}

Value text(const std::string& content) {
  return {content};
}

TEST(Range, ContainsItsBorderUnlessExcluded) {
  EXPECT_TRUE(Range::at_least(1).contains(1));
  EXPECT_FALSE(Range::at_least(1).contains(0.999));
  EXPECT_FALSE(Range::above(0).contains(0));
  EXPECT_TRUE(Range::above(0).contains(1e-300));
  EXPECT_TRUE(Range::between(0, 1).contains(0));
  EXPECT_TRUE(Range::between(0, 1).contains(1));
  EXPECT_FALSE(Range::between(0, 1).contains(1.001));
}

TEST(Range, NeverContainsWhatIsNotFinite) {
  EXPECT_FALSE(Range::any().contains(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(Range::any().contains(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(Range::at_least(0).contains(std::numeric_limits<double>::infinity()));
}

TEST(Range, IsSaidInWords) {
  EXPECT_EQ(to_string(Range::any()), "");
  EXPECT_EQ(to_string(Range::at_least(1)), "at least 1");
  EXPECT_EQ(to_string(Range::above(0)), "above 0");
  EXPECT_EQ(to_string(Range::between(0, 1)), "0 to 1");
  EXPECT_EQ(to_string(Range{0, 1, true}), "above 0, at most 1");
}

TEST(Parameters, KeepTheirDefaultsWhereNothingIsSaid) {
  const Result<Settings> settings = read_parameters<Settings>(Table{});
  ASSERT_TRUE(settings);
  EXPECT_EQ(settings->rows, 15U);
  EXPECT_EQ(settings->topology, Shape::kPlane);
  EXPECT_EQ(settings->radius, std::nullopt);
}

TEST(Parameters, AreReadByName) {
  EXPECT_EQ(read_one("rows", whole(20))->rows, 20U);
  EXPECT_EQ(read_one("learning_rate", {0.25})->learning_rate, 0.25);
  EXPECT_EQ(read_one("learning_rate", whole(1))->learning_rate, 1.0);
  EXPECT_FALSE(read_one("normalized", {false})->normalized);
  EXPECT_EQ(read_one("title", text("grasps"))->title, "grasps");
  EXPECT_EQ(read_one("topology", text("torus"))->topology, Shape::kTorus);
}

TEST(Parameters, OutOfRangeAreRefusedWithTheirPlace) {
  EXPECT_EQ(refusal("rows", whole(0)), "a.toml:2: 'rows' must be a whole number, 1 to 1000, not 0");
  EXPECT_EQ(refusal("rows", whole(1001)),
            "a.toml:2: 'rows' must be a whole number, 1 to 1000, not 1001");
  EXPECT_EQ(refusal("learning_rate", {0.0}),
            "a.toml:2: 'learning_rate' must be a number, above 0, not 0.0");
  EXPECT_EQ(refusal("learning_rate", {std::numeric_limits<double>::quiet_NaN()}),
            "a.toml:2: 'learning_rate' must be a number, above 0, not nan");
}

TEST(Parameters, ThatWouldNotFitTheirFieldAreRefused) {
  EXPECT_EQ(read_one("channel", whole(255))->channel, 255);
  EXPECT_EQ(refusal("channel", whole(256)),
            "a.toml:2: 'channel' must be a whole number, 0 to 255, not 256");
  EXPECT_EQ(refusal("channel", whole(-1)),
            "a.toml:2: 'channel' must be a whole number, 0 to 255, not -1");
}

TEST(Parameters, OfAnotherTypeAreRefused) {
  EXPECT_EQ(refusal("rows", {1.5}), "a.toml:2: 'rows' must be a whole number, 1 to 1000, not 1.5");
  EXPECT_EQ(refusal("rows", text("15")),
            "a.toml:2: 'rows' must be a whole number, 1 to 1000, not \"15\"");
  EXPECT_EQ(refusal("normalized", whole(1)), "a.toml:2: 'normalized' must be true or false, not 1");
  EXPECT_EQ(refusal("title", whole(1)), "a.toml:2: 'title' must be a text, not 1");
}

TEST(Parameters, WithUnknownChoicesNameTheNearest) {
  EXPECT_EQ(refusal("topology", text("tours")),
            "a.toml:2: 'topology' must be one of plane, torus, not \"tours\"; "
            "did you mean 'torus'?");
  EXPECT_EQ(refusal("topology", whole(1)),
            "a.toml:2: 'topology' must be one of plane, torus, not 1");
}

TEST(Parameters, UndeclaredNameTheNearest) {
  EXPECT_EQ(refusal("row", whole(1)), "a.toml:2: unknown key 'row'; did you mean 'rows'?");
}

TEST(Parameters, AreNotTables) {
  const Table table{"a.toml:1", {{"rows", "a.toml:2", Table{}}}};
  const Result<Settings> settings = read_parameters<Settings>(table);
  ASSERT_FALSE(settings);
  EXPECT_EQ(to_string(settings.error()),
            "a.toml:2: 'rows' must be a value, not a table; write rows = ...");
}

TEST(Parameters, MayBeAutomatic) {
  EXPECT_EQ(read_one("radius", {3.5})->radius, 3.5);
  Settings with_radius;
  with_radius.radius = 2.0;
  const Table table{"", {{"radius", "", text("automatic")}}};
  EXPECT_EQ(read_parameters(table, with_radius)->radius, std::nullopt);
  EXPECT_EQ(refusal("radius", text("auto")),
            "a.toml:2: 'radius' must be a number, at least 0, not \"auto\"; \"automatic\" is "
            "also accepted");
}

TEST(Parameters, MayBeLists) {
  EXPECT_EQ(read_one("weights", {Value::List{{0.5}, whole(3)}})->weights,
            (std::vector<double>{0.5, 3.0}));
  EXPECT_EQ(read_one("weights", {4.0})->weights, (std::vector<double>{4.0}));
  EXPECT_EQ(refusal("weights", {Value::List{{0.5}, {-1.0}}}),
            "a.toml:2: 'weights' must be a number, at least 0, not -1.0");
}

TEST(Parameters, StayAsTheyAreWhenRefused) {
  Settings settings;
  const auto refuses = [&](const std::string& name, const Value& value) {
    return !Settings::declarations().find(name)->assign(settings, value);
  };
  settings.radius = 2.0;
  EXPECT_TRUE(refuses("rows", whole(0)));
  EXPECT_TRUE(refuses("topology", text("ball")));
  EXPECT_TRUE(refuses("radius", {-1.0}));
  EXPECT_TRUE(refuses("weights", {Value::List{{0.5}, {-1.0}}}));
  EXPECT_EQ(settings.rows, 15U);
  EXPECT_EQ(settings.topology, Shape::kPlane);
  EXPECT_EQ(settings.radius, 2.0);
  EXPECT_EQ(settings.weights, (std::vector<double>{1.0, 2.0}));
}

TEST(Parameters, FilledInCodeAreCheckedToo) {
  Settings settings;
  EXPECT_TRUE(check_ranges(settings));
  settings.learning_rate = 0.0;
  const Result<void> checked = check_ranges(settings);
  ASSERT_FALSE(checked);
  EXPECT_EQ(to_string(checked.error()), "'learning_rate' must be a number, above 0, not 0.0");
}

TEST(Parameters, SayWhatTheyAre) {
  const ParameterInfo& rows = Settings::declarations().find("rows")->info;
  EXPECT_EQ(rows.type, "integer");
  EXPECT_EQ(rows.unit, "neurons");
  EXPECT_EQ(rows.default_text, "15");
  const ParameterInfo& topology = Settings::declarations().find("topology")->info;
  EXPECT_EQ(topology.type, "choice");
  EXPECT_EQ(topology.choices, (std::vector<std::string>{"plane", "torus"}));
  EXPECT_EQ(Settings::declarations().find("weights")->info.type, "list of number");
  EXPECT_EQ(Settings::declarations().find("radius")->info.default_text, "\"automatic\"");
  EXPECT_FALSE(Settings::declarations().find("columns"));
}

TEST(Parameters, AreWrittenAsToml) {
  Settings settings;
  settings.topology = Shape::kTorus;
  EXPECT_EQ(parameters_to_toml(settings),
            "rows = 15\nlearning_rate = 0.5\nnormalized = true\ntitle = \"map\"\n"
            "topology = \"torus\"\nradius = \"automatic\"\nweights = [1.0, 2.0]\n"
            "channel = 0\n");
}

// Reads a flag's argument for the parameter `name`.
Result<Settings> from_flag(const std::string& name, const std::string& argument) {
  return read_one(name, value_from_text(Settings::declarations().find(name)->info, argument));
}

struct Walls {
  std::vector<Shape> shapes{Shape::kPlane};
  std::optional<Shape> floor;

  static const Declarations<Walls>& declarations() {
    static const auto kAll = Declarations<Walls>()
                                 .add("shapes", &Walls::shapes, "", Range::any(), "Shapes of all.")
                                 .add("floor", &Walls::floor, "", Range::any(), "Below.");
    return kAll;
  }
};

// Lists of choices and choices that may be automatic are choices too.
TEST(Parameters, ChooseInListsAndOptionally) {
  for (const auto& parameter : Walls::declarations().all()) {
    EXPECT_EQ(parameter.info.choices, (std::vector<std::string>{"plane", "torus"}));
  }
  const Value both{Value::List{text("torus"), text("plane")}};
  const Table table{"a.toml:1",
                    {{"shapes", "a.toml:2", both}, {"floor", "a.toml:3", text("torus")}}};
  const Walls walls = read_parameters<Walls>(table).value();
  EXPECT_EQ(walls.shapes, (std::vector<Shape>{Shape::kTorus, Shape::kPlane}));
  EXPECT_EQ(walls.floor, Shape::kTorus);
}

struct Drive {
  double speed = 1.0;
  Settings settings;

  Drive() { settings.rows = 30; }
  static const Declarations<Drive>& declarations() {
    static const auto kAll =
        Declarations<Drive>()
            .add("speed", &Drive::speed, "mm/s", Range::above(0), "Speed of the hand.")
            .add(
                "title", [](Drive& d) -> auto& { return d.settings.title; }, "", Range::any(),
                "Settings of the map.")
            .add_from(&Drive::settings, Settings::declarations(), {"topology", "rows"});
    return kAll;
  }
};

TEST(Declarations, ReachFieldsOfNestedStructs) {
  const Table table{"", {{"title", "", text("drive")}, {"rows", "", whole(40)}}};
  const Drive drive = read_parameters<Drive>(table).value();
  EXPECT_EQ(drive.settings.title, "drive");
  EXPECT_EQ(drive.settings.rows, 40U);
  EXPECT_EQ(drive.speed, 1.0);
  EXPECT_EQ(parameters_to_toml(drive),
            "speed = 1.0\ntitle = \"drive\"\ntopology = \"plane\"\nrows = 40\n");
}

TEST(Declarations, TakeOverWhatANestedStructSays) {
  const ParameterInfo rows = Drive::declarations().find("rows")->info;
  EXPECT_EQ(rows.type, "integer");
  EXPECT_EQ(rows.unit, "neurons");
  EXPECT_EQ(rows.text, "Rows of the grid.");
  EXPECT_EQ(to_string(rows.range), "1 to 1000");
  EXPECT_EQ(rows.default_text, "30");
  EXPECT_EQ(Drive::declarations().find("topology")->info.choices,
            (std::vector<std::string>{"plane", "torus"}));
  Drive drive;
  const Result<void> assigned = Drive::declarations().find("rows")->assign(drive, whole(0));
  ASSERT_FALSE(assigned);
  EXPECT_EQ(to_string(assigned.error()), "'rows' must be a whole number, 1 to 1000, not 0");
}

TEST(Declarations, TakeOverOnlyWhatIsDeclared) {
  Declarations<Drive> drive;
  try {
    drive.add_from(&Drive::settings, Settings::declarations(), {"rows", "radios"});
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "unknown parameter 'radios'; did you mean 'radius'?");
  }
}

TEST(Declarations, ReachNothingOutsideTheirStruct) {
  const auto first_weight = [](Settings& s) -> auto& { return s.weights.front(); };
  EXPECT_THROW(Declarations<Settings>().add("weight", first_weight, "", Range::any(), "One."),
               InvalidArgument);
}

TEST(Declarations, ListWhatTheySay) {
  const std::vector<ParameterInfo> infos = Walls::declarations().infos();
  ASSERT_EQ(infos.size(), 2U);
  EXPECT_EQ(infos[1].name, "floor");
  EXPECT_EQ(infos[1].text, "Below.");
  EXPECT_EQ(Walls::declarations().names(), (std::vector<std::string>{"shapes", "floor"}));
}

TEST(Flags, AreReadByTheTypeOfTheirParameter) {
  EXPECT_EQ(from_flag("rows", "20")->rows, 20U);
  EXPECT_EQ(from_flag("learning_rate", "1e-3")->learning_rate, 1e-3);
  EXPECT_EQ(from_flag("learning_rate", "1")->learning_rate, 1.0);
  EXPECT_FALSE(from_flag("normalized", "false")->normalized);
  EXPECT_EQ(from_flag("title", "15")->title, "15");
  EXPECT_EQ(from_flag("radius", "2.5")->radius, 2.5);
  EXPECT_EQ(from_flag("radius", "automatic")->radius, std::nullopt);
  EXPECT_EQ(from_flag("weights", "1,2.5,3")->weights, (std::vector<double>{1.0, 2.5, 3.0}));
}

TEST(Flags, ThatCannotBeReadAreRefused) {
  for (const char* argument : {"", "15x", "1.5", "0x10", " 15", "99999999999999999999"}) {
    EXPECT_FALSE(from_flag("rows", argument)) << argument;
  }
  EXPECT_FALSE(from_flag("normalized", "yes"));
  EXPECT_FALSE(from_flag("learning_rate", "inf"));
  EXPECT_FALSE(from_flag("weights", "1,,2"));
  EXPECT_FALSE(from_flag("weights", "1,x"));
}

TEST(Choices, HaveNames) {
  EXPECT_EQ(choice_name(Shape::kTorus), "torus");
}

}  // namespace
}  // namespace somato
