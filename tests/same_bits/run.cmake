# Builds SOURCE with the compiler OTHER (Release) in WORK and compares what its program prints with
# what PROGRAM, built by the compiler of this tree, prints.
find_program(compiler NAMES ${OTHER} NO_CACHE)
if(NOT compiler)
  message(FATAL_ERROR "The other compiler, ${OTHER}, is missing; './dev setup' installs it.")
endif()

foreach(arguments
    "-S;${SOURCE};-B;${WORK};-G;Ninja;-DCMAKE_CXX_COMPILER=${compiler};-DCMAKE_BUILD_TYPE=Release"
    "--build;${WORK};--target;same_bits")
  execute_process(COMMAND ${CMAKE_COMMAND} ${arguments} COMMAND_ERROR_IS_FATAL ANY)
endforeach()

execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE here COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/same_bits OUTPUT_VARIABLE there COMMAND_ERROR_IS_FATAL ANY)
if(here STREQUAL "")
  message(FATAL_ERROR "${PROGRAM} printed nothing to compare")
endif()
if(NOT here STREQUAL there)
  message(FATAL_ERROR "The bits depend on the compiler. This tree:\n${here}\n${OTHER}:\n${there}")
endif()
message(STATUS "The same bits as by ${OTHER}:\n${here}")
