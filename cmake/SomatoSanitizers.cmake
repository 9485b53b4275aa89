set(SOMATO_SANITIZE "" CACHE STRING "Sanitizers for everything built here, such as address,undefined")

if(SOMATO_SANITIZE)
  add_compile_options(-fsanitize=${SOMATO_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${SOMATO_SANITIZE})
endif()
