# What `cmake --install` installs, in components: Program, Development, mpi, and python (python/CMakeLists.txt)
include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Shape_correspondence)
set(own_data_dir ${CMAKE_INSTALL_DATADIR}/shape_correspondence)
set(licence_dir ${CMAKE_INSTALL_DATADIR}/doc/shape-correspondence)

function(install_library library)
  install(TARGETS ${library} EXPORT ${library}Targets
          RUNTIME COMPONENT Program
          LIBRARY COMPONENT Program NAMELINK_COMPONENT Development
          ARCHIVE COMPONENT Development)
  install(EXPORT ${library}Targets NAMESPACE CGAL:: DESTINATION ${config_dir} COMPONENT Development)
endfunction()

install_library(Shape_correspondence)
install(DIRECTORY include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT Development)
install(DIRECTORY examples DESTINATION ${own_data_dir} COMPONENT Development) # they read ../../data
install(DIRECTORY doc/Shape_correspondence/schemas DESTINATION ${own_data_dir} COMPONENT Program)
install(FILES LICENSE CHANGES.md CITATION.cff src/viewer/page/three.LICENSE DESTINATION ${licence_dir} COMPONENT Program)
if(SHAPE_CORRESPONDENCE_PROGRAM)
  install_library(Shape_correspondence_IO)
  install_library(Shape_correspondence_Texture)
  install(TARGETS shape_correspondence COMPONENT Program)
  if(SHAPE_CORRESPONDENCE_MPI)
    install(TARGETS shape_correspondence_mpi COMPONENT mpi)
  endif()
  if(TARGET shape_correspondence_import)
    install(TARGETS shape_correspondence_import DESTINATION ${CMAKE_INSTALL_LIBEXECDIR} COMPONENT Program)
  endif()
  install(DIRECTORY data/ DESTINATION ${data_dir} COMPONENT Program)
  if(HELP2MAN)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/shape_correspondence.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
            COMPONENT Program)
  endif()
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/completion.bash RENAME shape_correspondence
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT Program)
endif()
configure_package_config_file(cmake/Shape_correspondenceConfig.cmake.in Shape_correspondenceConfig.cmake
                              INSTALL_DESTINATION ${config_dir} PATH_VARS CMAKE_INSTALL_LIBEXECDIR)
write_basic_package_version_file(Shape_correspondenceConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/Shape_correspondenceConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/Shape_correspondenceConfigVersion.cmake
        DESTINATION ${config_dir} COMPONENT Development)
