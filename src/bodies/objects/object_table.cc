#include "somato/bodies/object_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/core/contains.h"
#include "base/files/embedded.h"
#include "base/files/toml_file.h"
#include "base/files/whole_file.h"
#include "base/text/text.h"

namespace somato {
namespace {

constexpr Range kSize{0.0, 1000.0, true};  // mm; a hand's things, in no unit but mm
constexpr std::size_t kLargestMesh = std::size_t{64} << 20;
constexpr std::string_view kFolder = "objects/";
constexpr std::string_view kEnding = ".toml";

tl::unexpected<Error> refuse(std::string what, const std::string& where, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), where, std::move(advice));
}

// "a", or "an" before a vowel.
std::string with_article(const std::string& noun) {
  const bool vowel = std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun;
}

Result<void> check_name(std::string_view what, const Table::Entry& entry) {
  if (is_name(entry.name)) return {};
  return refuse(fmt::format("{} cannot be called {}", what, shown(entry.name)), entry.where,
                "use 1 to 255 bytes of text without control characters");
}

// The keys of a shape's line in the order in which a person would write them.
std::vector<std::string> keys_of(Shape shape) {
  std::vector<std::string> keys{"shape"};
  const ShapeKeys& own = shape_keys(shape);
  keys.insert(keys.end(), own.needed.begin(), own.needed.end());
  keys.insert(keys.end(), own.possible.begin(), own.possible.end());
  keys.insert(keys.end(), {"material", "mass"});
  return keys;
}

Result<Shape> shape_of(const Table& line, const std::string& where) {
  const Table::Entry* entry = line.find("shape");
  if (!entry) {
    return refuse("'shape' is missing", where, "write for example shape = \"cylinder\"");
  }
  return read_parameters<ObjectLine>(Table{where, {*entry}}).map([](const ObjectLine& only) {
    return only.shape;
  });
}

// Whether another key of the line gives the size.
bool is_given_by_share(const Table& line, std::string_view key) {
  return key == "depth" && line.find("depth_share") != nullptr;
}

// The shape's keys are there, and no other shape's.
Result<void> check_keys(const Table& line, Shape shape, const std::string& where) {
  const std::vector<std::string> known = keys_of(shape);
  const std::string what = fmt::format("key of {}", with_article(choice_name(shape)));
  for (const Table::Entry& entry : line.entries) {
    if (std::find(known.begin(), known.end(), entry.name) != known.end()) continue;
    return fail(unknown_name(what, entry.name, entry.where, known));
  }
  std::vector<std::string> needed = shape_keys(shape).needed;
  needed.emplace_back("material");
  for (const std::string& key : needed) {
    if (line.find(key) || is_given_by_share(line, key)) continue;
    return refuse(fmt::format("{} needs '{}'", with_article(choice_name(shape)), key), where,
                  fmt::format("its keys are: {}", fmt::join(known, ", ")));
  }
  if (line.find("depth") && line.find("depth_share")) {
    return refuse("the depth is given twice", line.find("depth_share")->where,
                  "use either 'depth' or 'depth_share'");
  }
  return {};
}

// An optional size without a value is "automatic", which is not a valid size here.
Result<void> check_given(const ObjectLine& line, const std::string& where) {
  const std::vector<std::pair<std::string, const std::optional<double>*>> sizes{
      {"diameter", &line.diameter},
      {"width", &line.width},
      {"depth", &line.depth},
      {"height", &line.height}};
  const std::vector<std::string>& needed = shape_keys(line.shape).needed;
  for (const auto& [key, size] : sizes) {
    const bool is_shared = key == "depth" && line.depth_share;
    if (*size || is_shared || std::find(needed.begin(), needed.end(), key) == needed.end()) {
      continue;
    }
    return refuse(fmt::format("'{}' must be a number", key), where, "write it in mm");
  }
  return {};
}

Result<void> check_proportions(const ObjectLine& line, const std::string& where) {
  if (line.shape == Shape::kCone && line.top_diameter > *line.diameter) {
    return refuse(fmt::format("the top of the cone, {} mm, is wider than its foot, {} mm",
                              line.top_diameter, *line.diameter),
                  where, "an object stands on its wider end");
  }
  if (line.shape == Shape::kCapsule && *line.height < *line.diameter) {
    return refuse(fmt::format("the capsule is {} mm high, less than its diameter of {} mm",
                              *line.height, *line.diameter),
                  where, "the height includes both ends; use a sphere or an ellipsoid");
  }
  return {};
}

std::array<double, 3> size_of(const ObjectLine& line) {
  if (line.shape == Shape::kMesh) return {};
  const double width = line.diameter ? *line.diameter : *line.width;
  const double depth = line.diameter      ? width
                       : line.depth_share ? *line.depth_share * width
                                          : *line.depth;
  return {width, depth, line.height ? *line.height : width};
}

bool has_mesh_ending(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending == ".stl" || ending == ".obj";
}

// The absolute path of a mesh relative to the folder of the table `table`.
Result<std::string> mesh_of(const ObjectLine& line, std::string_view table,
                            const std::string& where) {
  namespace fs = std::filesystem;
  if (!has_mesh_ending(line.file) || line.file.find('\0') != std::string::npos) {
    return refuse(fmt::format("{} is not a mesh", shown(line.file)), where,
                  "use a file with the extension .stl or .obj");
  }
  std::error_code ignored;
  const fs::path beside = fs::path(table).parent_path() / line.file;
  std::string path = fs::absolute(beside, ignored).lexically_normal().string();
  // A pipe or device would keep the reader waiting.
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) {
    return fail(ErrorKind::kData, fmt::format("{} is not a regular file", shown(path)), where,
                "use a file with the extension .stl or .obj");
  }
  Result<std::string> bytes = read_whole(path, kLargestMesh);
  if (bytes && !bytes->empty()) return path;
  if (bytes) return fail(ErrorKind::kData, shown(path) + " is empty", where, "export it again");
  return fail(bytes.error().kind, to_string(bytes.error()), where,
              "paths of meshes are relative to the folder of the table");
}

class TableReader {
 public:
  TableReader(std::string_view file, std::span<const Material> declared)
      : file_(file), declared_(declared), materials_(declared.begin(), declared.end()) {}

  Result<ObjectTable> read(const Table& root) {
    // Objects may be of materials that are declared below them.
    for (const std::string_view kind : {"material", "object"}) {
      for (const Table::Entry& entry : root.entries) {
        if (entry.name != kind) continue;
        SOMATO_TRY_VOID(read_all(entry));
      }
    }
    for (const Table::Entry& entry : root.entries) {
      if (entry.name == "material" || entry.name == "object") continue;
      return fail(unknown_name("table", entry.name, entry.where, {"object", "material"}));
    }
    if (!table_.objects.empty() || !table_.materials.empty()) return std::move(table_);
    return refuse("there are neither objects nor materials", root.where,
                  "add [object] with one line per object");
  }

 private:
  Result<void> read_all(const Table::Entry& entry) {
    const Table* all = std::get_if<Table>(&entry.content);
    if (!all) {
      return refuse(fmt::format("'{}' must be a table", entry.name), entry.where,
                    entry.name == "object" ? "write [object] on a separate line, objects below"
                                           : "write [material.NAME] on a separate line");
    }
    const bool objects = entry.name == "object";
    for (const Table::Entry& one : all->entries) {
      auto done = check_name(objects ? "an object" : "a material", one).and_then([&] {
        return objects ? read_object(one) : read_material(one);
      });
      if (!done) return done;
    }
    return {};
  }

  Result<void> read_material(const Table::Entry& entry) {
    const Table* keys = std::get_if<Table>(&entry.content);
    if (!keys) {
      return refuse(fmt::format("material '{}' must be a table", entry.name), entry.where,
                    fmt::format("write [material.{}] on a separate line", entry.name));
    }
    if (find_material(declared_, entry.name)) {
      return refuse(fmt::format("material '{}' is declared already", entry.name), entry.where,
                    "use another name");
    }
    return somato::read_material(entry.name, *keys).map([&](Material&& read) {
      materials_.push_back(read);
      table_.materials.push_back(std::move(read));
    });
  }

  Result<void> read_object(const Table::Entry& entry) {
    const Table* keys = std::get_if<Table>(&entry.content);
    if (!keys) {
      return refuse(fmt::format("object '{}' must be a table", entry.name), entry.where,
                    "write NAME = { shape = \"...\", ... }");
    }
    return line_of(*keys, entry.where)
        .and_then([&](const ObjectLine& line) { return object_of(line, entry); })
        .map([&](Object&& object) { table_.objects.push_back(std::move(object)); });
  }

  static Result<ObjectLine> line_of(const Table& keys, const std::string& where) {
    SOMATO_TRY(const auto shape, shape_of(keys, where));
    SOMATO_TRY_VOID(check_keys(keys, shape, where));
    Result<ObjectLine> line = read_parameters<ObjectLine>(keys);
    if (!line) return line;
    auto checked =
        check_given(*line, where).and_then([&] { return check_proportions(*line, where); });
    if (!checked) return fail(std::move(checked.error()));
    return line;
  }

  Result<Object> object_of(const ObjectLine& line, const Table::Entry& entry) const {
    auto material = find_material(materials_, line.material);
    if (!material) {
      material.error().where = entry.where;
      return fail(std::move(material.error()));
    }
    Object object;
    object.name = entry.name;
    object.shape = line.shape;
    object.size = size_of(line);
    object.top_diameter = line.top_diameter;
    object.material = std::move(*material);
    object.mesh_scale = line.scale;
    if (line.shape == Shape::kMesh) {
      SOMATO_TRY(auto path, mesh_of(line, file_, entry.where));
      object.mesh_file = std::move(path);
    }
    const bool known = line.mass || line.shape == Shape::kMesh;
    object.mass = known ? line.mass.value_or(0.0) : mass_of(object.material, volume(object));
    return object;
  }

  std::string_view file_;
  std::span<const Material> declared_;
  std::vector<Material> materials_;  // those declared and those of the table
  ObjectTable table_;
};

Result<std::vector<Object>> own_objects(std::string_view name, std::span<const Material> declared) {
  return own_object_table(name, declared).map([](ObjectTable&& table) {
    return std::move(table.objects);
  });
}

}  // namespace

const Declarations<ObjectLine>& ObjectLine::declarations() {
  using P = ObjectLine;
  static const auto declared =
      Declarations<P>()
          .add("shape", &P::shape, "", Range::any(), "Shape of the object. Required.")
          .add("diameter", &P::diameter, "mm", kSize,
               "Diameter of a sphere, cylinder or capsule, or of a cone at its base.")
          .add("width", &P::width, "mm", kSize, "Width of a block or ellipsoid.")
          .add("depth", &P::depth, "mm", kSize, "Depth of a block or ellipsoid.")
          .add("depth_share", &P::depth_share, "", Range{0.0, 1.0, true},
               "Depth of a block or ellipsoid as a share of its width, instead of 'depth'.")
          .add("height", &P::height, "mm", kSize,
               "Height of any shape except spheres and meshes; for a capsule including both ends.")
          .add("top_diameter", &P::top_diameter, "mm", Range::between(0, kSize.high),
               "Diameter of a cone at its top; 0: a point.")
          .add("file", &P::file, "", Range::any(),
               "File of a mesh, STL or OBJ, relative to the folder of the table.")
          .add("scale", &P::scale, "mm", kSize, "Length of a unit of the mesh's file.")
          .add("material", &P::material, "", Range::any(), "Name of the material. Required.")
          .add("mass", &P::mass, "kg", Range::between(1e-6, 1e4),
               "Mass of the object; automatic: computed from the volume and the material's "
               "density.");
  return declared;
}

const ShapeKeys& shape_keys(Shape shape) {
  static const std::vector<std::pair<Shape, ShapeKeys>> all{
      {Shape::kSphere, {{"diameter"}, {}}},
      {Shape::kCylinder, {{"diameter", "height"}, {}}},
      {Shape::kBlock, {{"width", "depth", "height"}, {"depth_share"}}},
      {Shape::kCone, {{"diameter", "height"}, {"top_diameter"}}},
      {Shape::kEllipsoid, {{"width", "depth", "height"}, {"depth_share"}}},
      {Shape::kCapsule, {{"diameter", "height"}, {}}},
      {Shape::kMesh, {{"file"}, {"scale"}}}};
  return std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == shape; })
      ->second;
}

Result<ObjectTable> parse_object_table(std::string_view text, std::string_view where,
                                       std::span<const Material> declared) {
  return parse_toml(text, where).and_then([&](const Table& root) {
    return object_table_of(root, where, declared);
  });
}

Result<ObjectTable> read_object_table(const std::string& path, std::span<const Material> declared) {
  return read_toml(path).and_then(
      [&](const Table& root) { return object_table_of(root, path, declared); });
}

Result<ObjectTable> object_table_of(const Table& table, std::string_view where,
                                    std::span<const Material> declared) {
  return TableReader(where, declared).read(table);
}

std::vector<std::string> own_object_tables() {
  std::vector<std::string> names;
  for (const detail::EmbeddedFile& file : detail::embedded_files()) {
    if (!file.path.starts_with(kFolder) || file.path == "objects/materials.toml") continue;
    names.emplace_back(
        file.path.substr(kFolder.size(), file.path.size() - kFolder.size() - kEnding.size()));
  }
  return names;
}

Result<ObjectTable> own_object_table(std::string_view name, std::span<const Material> declared) {
  const std::vector<std::string> known = own_object_tables();
  if (!contains(known, std::string(name))) {
    return fail(unknown_name("table of objects", name, "objects", known));
  }
  const std::string path = fmt::format("{}{}{}", kFolder, name, kEnding);
  return parse_object_table(detail::embedded_text(path), path, declared);
}

Result<ObjectTable> find_object_table(const std::string& name, std::span<const Material> declared) {
  return name.ends_with(".toml") ? read_object_table(name, declared)
                                 : own_object_table(name, declared);
}

Result<std::vector<Object>> lucs2_objects(std::span<const Material> declared) {
  return own_objects("lucs2", declared);
}

Result<std::vector<Object>> lucs3_objects(std::span<const Material> declared) {
  return own_objects("lucs3", declared);
}

Result<std::vector<Object>> lucs3_new_objects(std::span<const Material> declared) {
  return own_objects("lucs3_new", declared);
}

}  // namespace somato
