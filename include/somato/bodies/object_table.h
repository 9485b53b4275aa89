#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "somato/bodies/object.h"

namespace somato {

/// Objects to explore, and the materials declared with them.
struct ObjectTable {
  std::vector<Object> objects;
  std::vector<Material>
      materials;  ///< Materials of the table only, in addition to the declared ones.
};

/// The keys of an object's line in a table, with meaning and range; the keys of each shape are
/// given by shape_keys().
struct ObjectLine {
  Shape shape = Shape::kSphere;
  std::optional<double> diameter;
  std::optional<double> width;
  std::optional<double> depth;
  std::optional<double> depth_share;
  std::optional<double> height;
  double top_diameter = 0.0;
  std::string file;
  double scale = 1.0;
  std::string material;
  std::optional<double> mass;

  static const Declarations<ObjectLine>& declarations();
};

/// The required and the optional keys of a shape, in addition to `shape` and `material` (always
/// required) and `mass` (always optional).
struct ShapeKeys {
  std::vector<std::string> needed;
  std::vector<std::string> possible;
};
/// The keys of a shape.
const ShapeKeys& shape_keys(Shape shape);

/// The table in the TOML `text` (docs/objects.md), in the order of the text. `where` is its file;
/// files of meshes are relative to its folder. Objects have materials of the table or of those
/// `declared`. Errors, with file and line: kUsage for unknown tables, keys, shapes and materials,
/// missing keys of a shape, sizes out of range, a cone whose top is wider than its foot, a capsule
/// whose height is below its diameter, invalid names, a material with a declared name, an empty
/// table; kSystem and kData for the file of a mesh that cannot be read, is empty or is larger than
/// 64 MiB.
Result<ObjectTable> parse_object_table(std::string_view text, std::string_view where,
                                       std::span<const Material> declared);

/// The table in the file at `path`; see parse_object_table() and read_toml().
Result<ObjectTable> read_object_table(const std::string& path, std::span<const Material> declared);

/// The objects and materials of `table`, which has the tables `object` and `material` of such a
/// file. Files of meshes are relative to the folder of `where`. Errors: those of
/// parse_object_table().
Result<ObjectTable> object_table_of(const Table& table, std::string_view where,
                                    std::span<const Material> declared);

/// The names of the built-in tables of objects, the files of `objects/` except materials.toml, in
/// alphabetical order: "all_senses", "lucs2", and so on.
std::vector<std::string> own_object_tables();

/// The built-in table with that name, such as "lucs3_new": a file of `objects/`. Errors (kUsage):
/// an unknown name, with the nearest known one; those of parse_object_table().
Result<ObjectTable> own_object_table(std::string_view name, std::span<const Material> declared);

/// The table in a file whose name ends in `.toml`, or the built-in table with that name. Errors:
/// those of read_object_table() or own_object_table().
Result<ObjectTable> find_object_table(const std::string& name, std::span<const Material> declared);

/// The objects of Table I (P06), explored with LUCS Haptic Hand II. The materials plastic, metal,
/// hard_board and wood must be among those `declared`; otherwise an error names the missing one.
Result<std::vector<Object>> lucs2_objects(std::span<const Material> declared);

/// Five cylinders and five blocks for LUCS Haptic Hand III. The table is Somato's own, and so is
/// that of new objects with intermediate sizes; the papers' Table II is not known. The materials
/// are those of lucs2_objects().
Result<std::vector<Object>> lucs3_objects(std::span<const Material> declared);
/// The three new cylinders and the three new blocks.
Result<std::vector<Object>> lucs3_new_objects(std::span<const Material> declared);

}  // namespace somato
