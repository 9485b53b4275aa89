# Installs the official MCAP packages from npm, as package-lock.json says, into the folder TO; costs
# nothing when they are there. -DNPM=PROGRAM -DFROM=FOLDER -DTO=FOLDER
set(stamp ${TO}/installed)
file(READ ${FROM}/package-lock.json wanted)
if(EXISTS ${stamp})
  file(READ ${stamp} installed)
endif()
file(COPY ${FROM}/package.json ${FROM}/package-lock.json ${FROM}/read.mjs ${FROM}/write.mjs
     DESTINATION ${TO})
if("${wanted}" STREQUAL "${installed}")
  return()
endif()
file(REMOVE ${stamp})
execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund WORKING_DIRECTORY ${TO}
                RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "npm cannot install the official MCAP reader (${status}); is its registry "
                      "within reach? 'npm config get registry' shows which it is")
endif()
file(WRITE ${stamp} "${wanted}")
