# docs/reference/flags-and-keys.md is what `somato reference` prints.
# -DPROGRAM=FILE -DPAGE=FILE
execute_process(COMMAND ${PROGRAM} reference OUTPUT_VARIABLE printed RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "'${PROGRAM} reference' failed: ${status}")
endif()
file(READ ${PAGE} page)
if(NOT printed STREQUAL page)
  message(FATAL_ERROR "${PAGE} is not what the program prints.\n"
    "Make it anew: build/release/somato reference > docs/reference/flags-and-keys.md")
endif()
