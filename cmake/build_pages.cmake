# Builds the pages with npm in the folder WORK and writes the C++ file TO that carries them:
# cmake -DNPM=PROGRAM -DNODE=PROGRAM -DFROM=web -DWORK=FOLDER -DTO=FILE -P build_pages.cmake
# npm installs into WORK, as package-lock.json says, and only when that has changed.
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status
                  OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "The pages cannot be built ('${ARGN}' ended with ${status}); "
                        "-DSOMATO_BUILD_PAGES=OFF does without.\n${output}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${WORK})
file(LOCK ${WORK} DIRECTORY GUARD PROCESS TIMEOUT 600)
set(stamp ${WORK}/installed)
file(READ ${FROM}/package-lock.json wanted)
if(EXISTS ${stamp})
  file(READ ${stamp} installed)
endif()
file(GLOB old ${WORK}/*.ts ${WORK}/*.mjs)
file(REMOVE_RECURSE ${old} ${WORK}/src ${WORK}/tests)
file(GLOB sources ${FROM}/*.json ${FROM}/*.ts ${FROM}/*.mjs ${FROM}/*.html)
file(COPY ${sources} ${FROM}/src ${FROM}/tests DESTINATION ${WORK})
if(NOT "${wanted}" STREQUAL "${installed}")
  file(REMOVE ${stamp})
  run(${NPM} ci --ignore-scripts --no-audit --no-fund)
  file(WRITE ${stamp} "${wanted}")
endif()
run(${NODE} build.mjs)

set(entries "")
foreach(page report.html view.html view.js view.css)
  if(NOT EXISTS ${WORK}/dist/${page})
    continue()
  endif()
  file(READ ${WORK}/dist/${page} text)
  string(APPEND entries "    {\"${page}\", R\"embedded(${text})embedded\"},\n")
endforeach()
set(written "#include \"report/pages.h\"

namespace somato::program {

const std::vector<Page>& pages() {
  static const std::vector<Page> all = {
${entries}  };
  return all;
}

}  // namespace somato::program
")
# Other tests of the same pages compile nothing.
set(before "")
if(EXISTS ${TO})
  file(READ ${TO} before)
endif()
if(NOT before STREQUAL written)
  file(WRITE ${TO} "${written}")
endif()
