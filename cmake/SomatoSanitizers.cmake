set(SOMATO_SANITIZE "" CACHE STRING "Sanitizers for everything built here, such as address,undefined")

if(SOMATO_SANITIZE)
  add_compile_options(-fsanitize=${SOMATO_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${SOMATO_SANITIZE})
  # The checks' descriptions contain 800,000 addresses, whose relocation at each start takes longer than many a
  # command. The thread sanitizer needs programs that can be moved.
  if(SOMATO_SANITIZE MATCHES address)
    add_link_options("$<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-no-pie>")
  endif()
endif()
