# somato_embed(SOURCE FILE...): writes the C++ file SOURCE, which holds the texts of the FILEs (paths
# from the top of the tree) for base/files/embedded.h.
function(somato_embed source)
  set(entries "")
  foreach(file ${ARGN})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${file}")
    file(READ "${PROJECT_SOURCE_DIR}/${file}" text)
    string(APPEND entries "    {\"${file}\", R\"embedded(${text})embedded\"},\n")
  endforeach()
  file(WRITE "${source}.new" "#include \"base/files/embedded.h\"

namespace somato::detail {

const std::vector<EmbeddedFile>& embedded_files() {
  static const std::vector<EmbeddedFile> files = {
${entries}  };
  return files;
}

}  // namespace somato::detail
")
  configure_file("${source}.new" "${source}" COPYONLY)
endfunction()
