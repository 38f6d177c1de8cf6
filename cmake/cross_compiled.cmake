# The libraries for browsers and Windows: those headers of the system that do not depend on the machine, by symbolic links in a
# separate folder, since the headers beside them belong to the system's C library.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(name CGAL boost nlohmann nanoflann.hpp)
  if(NOT EXISTS /usr/include/${name})
    message(FATAL_ERROR "/usr/include/${name} is missing; scripts/install_packages installs it")
  endif()
  file(CREATE_LINK /usr/include/${name} ${headers}/${name} SYMBOLIC)
endforeach()
foreach(library CGAL::CGAL Boost::headers nanoflann::nanoflann nlohmann_json::nlohmann_json Eigen3::Eigen)
  add_library(${library} INTERFACE IMPORTED)
  target_include_directories(${library} SYSTEM INTERFACE ${headers})
endforeach()
target_include_directories(Eigen3::Eigen SYSTEM INTERFACE /usr/include/eigen3)
target_compile_definitions(CGAL::CGAL INTERFACE CGAL_DISABLE_GMP)
if(SHAPE_CORRESPONDENCE_PROGRAM) # Debian has Boost.Program_options compiled for its own systems only
  set(SHAPE_CORRESPONDENCE_BOOST_SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/build-boost
      CACHE PATH "Sources of the Boost whose headers are installed: libs/program_options/src is in it")
  file(GLOB program_options_sources ${SHAPE_CORRESPONDENCE_BOOST_SOURCES}/libs/program_options/src/*.cpp)
  if(NOT program_options_sources)
    message(FATAL_ERROR "The sources of Boost.Program_options are not in ${SHAPE_CORRESPONDENCE_BOOST_SOURCES}; "
                        "scripts/get_boost_sources gets them")
  endif()
  add_library(Boost_program_options STATIC EXCLUDE_FROM_ALL ${program_options_sources})
  target_link_libraries(Boost_program_options PUBLIC Boost::headers)
  add_library(Boost::program_options ALIAS Boost_program_options)
endif()
if(EMSCRIPTEN)
  target_compile_options(Eigen3::Eigen INTERFACE -msimd128 "SHELL:-include ${CMAKE_CURRENT_LIST_DIR}/browser_eigen.h")
  target_compile_definitions(CGAL::CGAL INTERFACE CGAL_ALWAYS_ROUND_TO_NEAREST)
  # With -Os, Emscripten would switch off inlining, and a match would take five times as long
  add_compile_options(-fwasm-exceptions -Xclang -fno-pch-timestamp -sINLINING_LIMIT=0)
  add_link_options(-fwasm-exceptions)
else()
  target_compile_options(CGAL::CGAL INTERFACE -frounding-math) # as in CGAL's own target
  # The stack of a thread on Windows is aligned for vectors of 16 bytes only: gcc.gnu.org/PR54412
  add_compile_options(-Wa,-muse-unaligned-vector-move)
  add_link_options(-static -Wl,--stack,8388608) # a program that needs no libraries; a stack of 8 MB as on Linux
endif()
