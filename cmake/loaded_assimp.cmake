# The program loads a shared library of assimp only when it reads a file with it, since that takes longer than the match of two
# shapes of which the graphs are known. Only a static one is linked. `assimp_is_loaded` says which is the case,
# `assimp_libraries` under which names the library is looked for
get_target_property(assimp_type assimp::assimp TYPE)
get_target_property(assimp_configurations assimp::assimp IMPORTED_CONFIGURATIONS)
list(GET assimp_configurations 0 assimp_configuration)
get_target_property(assimp_soname assimp::assimp IMPORTED_SONAME_${assimp_configuration})
get_target_property(assimp_location assimp::assimp IMPORTED_LOCATION_${assimp_configuration})
if(assimp_type STREQUAL "STATIC_LIBRARY" OR NOT assimp_location)
  set(assimp_is_loaded OFF)
else()
  set(assimp_is_loaded ON)
  set(assimp_libraries ${assimp_location})
  if(assimp_soname) # first: the library that the system has under the name may be a later one of the same interface
    get_filename_component(assimp_soname ${assimp_soname} NAME) # of macOS it begins with @rpath
    list(PREPEND assimp_libraries ${assimp_soname})
  endif()
endif()

function(use_assimp library)
  if(NOT assimp_is_loaded)
    target_link_libraries(${library} PRIVATE assimp::assimp)
    return()
  endif()
  list(TRANSFORM assimp_libraries REPLACE "(.+)" "\"\\1\"" OUTPUT_VARIABLE names)
  string(REPLACE ";" "," names "${names}")
  set_property(SOURCE src/io/read/assimp_functions.cpp APPEND PROPERTY
               COMPILE_DEFINITIONS "SHAPE_CORRESPONDENCE_ASSIMP_LIBRARIES=${names}")
  set_source_files_properties(src/io/read/assimp_functions.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_include_directories(${library} SYSTEM PRIVATE $<TARGET_PROPERTY:assimp::assimp,INTERFACE_INCLUDE_DIRECTORIES>)
  target_link_libraries(${library} PRIVATE ${CMAKE_DL_LIBS})
endfunction()
