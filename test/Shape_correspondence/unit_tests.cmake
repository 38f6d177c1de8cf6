# The tests that need Catch2, 2.13 or later

# What all of them are compiled and linked with: Catch2's own main, and the headers that most tests begin with, precompiled
add_library(test_settings INTERFACE)
target_link_libraries(test_settings INTERFACE Shape_correspondence Shape_correspondence_private)
if(Catch2_VERSION VERSION_LESS 3)
  target_link_libraries(test_settings INTERFACE Catch2::Catch2)
else() # headers with the names of version 2
  target_link_libraries(test_settings INTERFACE Catch2::Catch2WithMain)
  target_include_directories(test_settings INTERFACE ${CMAKE_CURRENT_SOURCE_DIR}/catch2_3)
endif()
target_compile_definitions(test_settings INTERFACE SHAPE_CORRESPONDENCE_DATA_DIR="${PROJECT_SOURCE_DIR}/data")
if(NOT SHAPE_CORRESPONDENCE_CORE_ONLY)
  target_link_libraries(test_settings INTERFACE Shape_correspondence_Texture)
  target_compile_definitions(test_settings INTERFACE SHAPE_CORRESPONDENCE_PROGRAM="$<TARGET_FILE:shape_correspondence>")
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(test_settings INTERFACE -O1) # tests are compiled more often than they run
endif()
add_library(test_main OBJECT test_main.cpp)
target_link_libraries(test_main PUBLIC test_settings)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/test_headers.cpp CONTENT "// Has the precompiled header of the tests\n")
add_library(test_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/test_headers.cpp)
target_link_libraries(test_headers PRIVATE test_settings)
target_precompile_headers(test_headers PRIVATE <catch2/catch.hpp> <CGAL/Shape_correspondence/Structural_graph.h>)

# Whether a test, with the headers of tests that it includes, needs nothing but the rooms of the library that is built
function(is_of_library source result)
  set(${result} OFF PARENT_SCOPE)
  file(READ ${source} text)
  if(text MATCHES "SHAPE_CORRESPONDENCE_PROGRAM")
    return()
  endif()
  string(REGEX MATCHALL "#include (\"|<CGAL/Shape_correspondence/)[A-Za-z0-9_/]+\\.h" includes "${text}")
  foreach(include ${includes})
    string(REGEX REPLACE "#include (\"|<CGAL/Shape_correspondence/)" "" header ${include})
    get_filename_component(room ${header} DIRECTORY)
    get_filename_component(name ${header} NAME_WE)
    if(include MATCHES "<CGAL")
      file(GLOB owner RELATIVE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/src/*/${name}.cpp)
      get_filename_component(owner "${owner}" DIRECTORY)
      if(NOT owner) # a header with no source of its name: its room is in the table
        string(REGEX REPLACE "\\.h$" "" header ${header})
        file(STRINGS ${PROJECT_SOURCE_DIR}/src/README.md owner REGEX "^\\| ${header} \\|" LIMIT_COUNT 1)
        string(REGEX REPLACE ".*\\| ([a-z/]+) \\|$" "\\1" owner "${owner}")
      endif()
      if(NOT owner IN_LIST library_rooms)
        return()
      endif()
    elseif(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${header})
      is_of_library(${CMAKE_CURRENT_SOURCE_DIR}/${header} is_helper_of_library)
      if(NOT is_helper_of_library)
        return()
      endif()
    elseif(NOT room IN_LIST library_rooms)
      return()
    endif()
  endforeach()
  set(${result} ON PARENT_SCOPE)
endfunction()

# One test program for each public header, linked with the compiled library
file(GLOB test_sources CONFIGURE_DEPENDS test_*.cpp)
list(FILTER test_sources EXCLUDE REGEX "test_main.cpp$")
foreach(source ${test_sources})
  get_filename_component(name ${source} NAME_WE)
  if(SHAPE_CORRESPONDENCE_CORE_ONLY)
    is_of_library(${source} is_test_of_library)
    if(NOT is_test_of_library)
      continue()
    endif()
  endif()
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE test_main)
  target_precompile_headers(${name} REUSE_FROM test_headers)
  if(TARGET shape_correspondence)
    add_dependencies(${name} shape_correspondence)
  endif()
  add_test(NAME ${name} COMMAND ${name})
endforeach()

# The library lacks this source if the standard library converts numbers
target_sources(test_number_text PRIVATE ${PROJECT_SOURCE_DIR}/src/base/number_text.cpp)

if(SHAPE_CORRESPONDENCE_CORE_ONLY)
  return()
endif()
target_link_libraries(test_exported_formats PRIVATE assimp::assimp) # the test writes files with assimp
target_link_libraries(test_library_call PRIVATE Shape_correspondence_commands) # commands run in the test itself

if(MINIZIP_INCLUDE_DIR AND MINIZIP_LIBRARY)
  target_compile_definitions(test_read_3mf PRIVATE SHAPE_CORRESPONDENCE_WITH_MINIZIP)
endif()
foreach(codec draco::draco meshoptimizer::meshoptimizer) # the test compresses what it reads
  if(TARGET ${codec})
    string(REGEX REPLACE ":.*" "" name ${codec})
    string(TOUPPER ${name} name)
    target_link_libraries(test_read_gltf PRIVATE ${codec})
    target_compile_definitions(test_read_gltf PRIVATE SHAPE_CORRESPONDENCE_WITH_${name})
  endif()
endforeach()

# Makes system calls of the program fail
if(UNIX AND NOT APPLE)
  add_library(failing_calls MODULE failing_calls.cpp)
  target_link_libraries(failing_calls PRIVATE ${CMAKE_DL_LIBS})
  add_dependencies(test_faults failing_calls)
  target_compile_definitions(test_faults PRIVATE SHAPE_CORRESPONDENCE_FAILING_CALLS="$<TARGET_FILE:failing_calls>")
endif()

# The test of parallel loops, without TBB
add_executable(test_plain_threads test_for_each_index.cpp ${PROJECT_SOURCE_DIR}/src/base/for_each_index.cpp)
target_link_libraries(test_plain_threads PRIVATE test_main)
target_compile_options(test_plain_threads PRIVATE -UCGAL_LINKED_WITH_TBB)
add_test(NAME test_plain_threads COMMAND test_plain_threads)

# The test compares version.h with the version of the project
target_compile_definitions(test_program PRIVATE SHAPE_CORRESPONDENCE_PROJECT_VERSION="${PROJECT_VERSION}")

# Tests that share headers with the benchmarks, or use generated shapes
foreach(name test_peers test_role_validation)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/benchmark/Shape_correspondence)
endforeach()
foreach(name test_generate_models test_drawn_shapes test_Shape_appearance test_transfer_appearance
             test_transfer_command test_exported_formats test_blind_matching test_detect_symmetry_groups test_detect_contacts test_abstract_part_geometry
             test_estimate_up)
  target_link_libraries(${name} PRIVATE Shape_correspondence_generator)
endforeach()

if(SHAPE_CORRESPONDENCE_MPI)
  target_compile_definitions(test_collection PRIVATE SHAPE_CORRESPONDENCE_MPIRUN="${MPIEXEC_EXECUTABLE}"
                             SHAPE_CORRESPONDENCE_MPI_PROGRAM="$<TARGET_FILE:shape_correspondence_mpi>")
  add_dependencies(test_collection shape_correspondence_mpi)
endif()
