# groundgrid_warnings(TARGET): the warnings our own targets are built with.
function(groundgrid_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wsign-conversion -Wdouble-promotion
                                           -Wnon-virtual-dtor -Woverloaded-virtual)
  if(GROUNDGRID_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
