# libsomato.so, linked of the objects of the static library: it exports what the public headers declare
# (docs/decisions/0050-packages.md).
set(SOMATO_SOVERSION 1)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(exports ${PROJECT_BINARY_DIR}/exports.map)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/somato/*.h)
add_custom_command(OUTPUT ${exports}
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/scripts/release/exported_symbols.py ${PROJECT_SOURCE_DIR}/include/somato
          $<TARGET_FILE:somato> SOMATO_${SOMATO_SOVERSION} --nm ${CMAKE_NM} > ${exports}
  DEPENDS somato ${headers} ${PROJECT_SOURCE_DIR}/scripts/release/exported_symbols.py)
add_custom_target(somato_exports_map DEPENDS ${exports})

add_library(somato_shared SHARED $<TARGET_OBJECTS:somato> $<TARGET_OBJECTS:somato_optimized>)
add_library(somato::shared ALIAS somato_shared)
add_dependencies(somato_shared somato_exports_map)
set_target_properties(somato_shared PROPERTIES OUTPUT_NAME somato LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/src
                      EXPORT_NAME shared LINKER_LANGUAGE CXX
                      VERSION ${SOMATO_SOVERSION}.${PROJECT_VERSION_MINOR}.${PROJECT_VERSION_PATCH}
                      SOVERSION ${SOMATO_SOVERSION} LINK_DEPENDS ${exports})
target_compile_features(somato_shared PUBLIC cxx_std_20)
target_include_directories(somato_shared PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                                $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
get_target_property(libraries somato LINK_LIBRARIES)
list(REMOVE_ITEM libraries tl::expected Threads::Threads)
target_link_libraries(somato_shared PUBLIC tl::expected Threads::Threads PRIVATE ${libraries})
# Calls within the library need no table: nothing replaces its functions.
target_link_options(somato_shared PRIVATE LINKER:--version-script=${exports} LINKER:-Bsymbolic-functions
                    LINKER:-z,defs)
