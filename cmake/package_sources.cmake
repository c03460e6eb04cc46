if(BUILD_SHARED_LIBS)
  message(FATAL_ERROR "A Python package has the library inside of its module: expected "
    "BUILD_SHARED_LIBS=OFF, got ${BUILD_SHARED_LIBS}")
endif()

# For pip, which shows only the end of a long log: says all at once what is missing, by the names
# that Debian has, before the first library asks for its own.
set(missing)
foreach(package
    "Eigen3 libeigen3-dev" "TBB libtbb-dev" "hwy libhwy-dev" "fmt libfmt-dev"
    "nlohmann_json nlohmann-json3-dev" "toml11 libtoml11-dev" "embree libembree-dev")
  separate_arguments(package)
  list(GET package 0 name)
  find_package(${name} QUIET)
  if(NOT ${name}_FOUND)
    list(APPEND missing "${package}")
  endif()
endforeach()
find_path(LZF_INCLUDE_DIR liblzf/lzf.h)
find_library(LZF_LIBRARY lzf)
if(NOT LZF_INCLUDE_DIR OR NOT LZF_LIBRARY)
  list(APPEND missing "liblzf;liblzf-dev")
endif()

if(missing)
  set(names)
  while(missing)
    list(POP_FRONT missing name debian)
    string(APPEND names " ${debian}")
  endwhile()
  message(FATAL_ERROR "To build groundgrid from its sources these are missing:\n"
    "    sudo apt-get install${names}\n"
    "These are the names of Debian 12; other systems have others. "
    "A wheel, which `make wheel` builds, needs none of them.")
endif()
