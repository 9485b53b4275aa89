# The wheel of the Python package is built with the physics engine of the package mujoco, which pip
# installs for the build (pyproject.toml).
find_package(Python 3.10 REQUIRED COMPONENTS Interpreter)
execute_process(COMMAND ${Python_EXECUTABLE} -c
                        "import importlib.util as u; print(u.find_spec('mujoco').submodule_search_locations[0])"
                OUTPUT_VARIABLE mujoco OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
set(MUJOCO_ROOT "${mujoco}" CACHE PATH "Folder of the package mujoco" FORCE)

# somato_announce_wheel(TARGET...): says what pip is compiling and how long it takes. pip hides the output of a
# build unless it is given -v, so the message is also written to the terminal, if there is one.
function(somato_announce_wheel)
  set(sources 0)
  foreach(target IN LISTS ARGN)
    get_target_property(of_target ${target} SOURCES)
    list(FILTER of_target INCLUDE REGEX "\\.cc$")
    list(LENGTH of_target count)
    math(EXPR sources "${sources} + ${count}")
  endforeach()
  # Measured with g++ 12 on two shared cores of an AMD EPYC, without ccache, the pages included.
  set(processor_seconds 460)
  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  math(EXPR minutes "(${processor_seconds} / ${cores} + 89) / 60")
  set(text "pysomato: compiling ${sources} C++ files of the library, the program and the package; about ${minutes}\
 min if the ${cores} cores are idle (pip -v shows the progress)")
  message(STATUS "${text}")
  execute_process(COMMAND sh -c "printf '\\n  %s\\n' \"$1\" >/dev/tty" sh "${text}"
                  OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE without_terminal)
endfunction()
