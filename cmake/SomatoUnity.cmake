# The sources of a wing are compiled together: reading headers and instantiating templates takes longer
# than the rest of a typical file. Names in the anonymous namespaces of a wing must therefore differ.
set(SOMATO_SOURCES_AT_ONCE 64 CACHE STRING "Number of sources that are compiled at once")

# somato_has_own_options(OUT SOURCE): whether a source is compiled unlike the others of its target.
function(somato_has_own_options out source)
  set(${out} FALSE PARENT_SCOPE)
  foreach(property COMPILE_OPTIONS COMPILE_DEFINITIONS SKIP_PRECOMPILE_HEADERS)
    get_source_file_property(value "${source}" ${property})
    if(value)
      set(${out} TRUE PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# somato_compile_together(TARGET): the sources of each wing in TARGET are compiled in groups; a source with options of its own
# is compiled separately. The text of a group contains no path of the checkout, unlike the groups of CMake's UNITY_BUILD, so
# that the compiler's cache recognizes it in another checkout without reading the headers. The groups are made at the end of
# the folder, when the options of all its sources are known.
function(somato_compile_together target)
  if(SOMATO_SOURCES_AT_ONCE GREATER 1)
    cmake_language(EVAL CODE "cmake_language(DEFER CALL somato_make_groups ${target})")
  endif()
endfunction()

# somato_make_groups(TARGET): the groups of one target.
function(somato_make_groups target)
  get_target_property(sources ${target} SOURCES)
  set(wings)
  foreach(source IN LISTS sources)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY "${PROJECT_SOURCE_DIR}")
    string(REGEX MATCH "^(src/|tests/)?[^/]+" wing "${source}")
    somato_has_own_options(is_separate ${PROJECT_SOURCE_DIR}/${source})
    if(is_separate OR NOT source MATCHES "^(src|tests|program)/.*[.]cc$")
      continue()
    endif()
    string(MAKE_C_IDENTIFIER "${wing}" wing)
    list(APPEND wings ${wing})
    list(APPEND of_${wing} ${source})
  endforeach()
  list(REMOVE_DUPLICATES wings)
  foreach(wing IN LISTS wings)
    somato_add_groups(${target} ${wing} ${of_${wing}})
  endforeach()
endfunction()

# somato_add_groups(TARGET WING SOURCE...): sources relative to the checkout, in groups of equal size. If the target has a
# property SOMATO_OPTIONS_OF_WING, they are compiled with these options, and without headers that were precompiled without them.
function(somato_add_groups target wing)
  get_target_property(options ${target} SOMATO_OPTIONS_OF_${wing})
  list(LENGTH ARGN count)
  math(EXPR groups "(${count} + ${SOMATO_SOURCES_AT_ONCE} - 1) / ${SOMATO_SOURCES_AT_ONCE}")
  set(place 0)
  foreach(source IN LISTS ARGN)
    math(EXPR group "${place} * ${groups} / ${count}")
    string(APPEND text_${group} "#include \"${source}\"\n")
    math(EXPR place "${place} + 1")
    set_source_files_properties(${PROJECT_SOURCE_DIR}/${source} PROPERTIES HEADER_FILE_ONLY ON)
  endforeach()
  math(EXPR last "${groups} - 1")
  foreach(group RANGE ${last})
    set(file ${CMAKE_CURRENT_BINARY_DIR}/together/${target}/${wing}_${group}.cc)
    file(CONFIGURE OUTPUT ${file} CONTENT "${text_${group}}" @ONLY)
    set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS "-iquote;${PROJECT_SOURCE_DIR}")
    if(options)
      set_property(SOURCE ${file} APPEND PROPERTY COMPILE_OPTIONS ${options})
      set_property(SOURCE ${file} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
    endif()
    target_sources(${target} PRIVATE ${file})
  endforeach()
endfunction()
