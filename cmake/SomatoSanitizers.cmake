set(SOMATO_SANITIZE "" CACHE STRING "Sanitizers for everything built here, such as address,undefined")

if(SOMATO_SANITIZE)
  add_compile_options(-fsanitize=${SOMATO_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${SOMATO_SANITIZE})
  if(SOMATO_SANITIZE MATCHES undefined AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # The compiler's cache would take an absolute path for a difference between checkouts; Ninja compiles in one folder.
    set(unchecked ${PROJECT_SOURCE_DIR}/cmake/unchecked_pointers.txt)
    if(CMAKE_GENERATOR STREQUAL "Ninja")
      file(RELATIVE_PATH unchecked ${CMAKE_BINARY_DIR} ${unchecked})
    endif()
    add_compile_options(-fsanitize-ignorelist=${unchecked})
  endif()
  # The checks' descriptions contain 800,000 addresses, whose relocation at each start takes longer than many a
  # command. The thread sanitizer needs programs that can be moved.
  if(SOMATO_SANITIZE MATCHES address)
    add_link_options("$<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-no-pie>")
  endif()
endif()
