# groundgrid_threads(TARGET SCOPE): what tiles run on, oneTBB or, where GROUNDGRID_STD_THREAD asks for
# it, std::thread.
function(groundgrid_threads target scope)
  if(GROUNDGRID_STD_THREAD)
    find_package(Threads REQUIRED)
    target_compile_definitions(${target} ${scope} GROUNDGRID_STD_THREAD)
    target_link_libraries(${target} ${scope} Threads::Threads)
  else()
    find_package(TBB REQUIRED)
    target_link_libraries(${target} ${scope} TBB::tbb)
  endif()
endfunction()
