# What `cmake --install` puts into a prefix: shared libraries with hidden symbols and their headers, the program with the
# files that it ships, a CMake package `contact` with the components shapes, contact and dem, and contact.pc.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

file(STRINGS libcontact/version.h version_line REGEX "define CONTACT_VERSION \"")
string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" header_version "${version_line}")
if(NOT header_version STREQUAL PROJECT_VERSION)
  message(FATAL_ERROR "libcontact/version.h says ${header_version}, CMakeLists.txt ${PROJECT_VERSION}")
endif()

foreach(layer shapes libcontact libdem)
  install(
    DIRECTORY ${layer}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING
    PATTERN "*.h"
    PATTERN "data" EXCLUDE
    PATTERN "scenes" EXCLUDE
    PATTERN "cli" EXCLUDE
    PATTERN "report" EXCLUDE
    PATTERN "validate" EXCLUDE)
endforeach()
install(TARGETS dem RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
set(shared_files ${CMAKE_INSTALL_DATADIR}/contact_mechanics)
install(DIRECTORY shapes/data/ DESTINATION ${shared_files}/shapes)
install(DIRECTORY libdem/scenes/ DESTINATION ${shared_files}/scenes)
install(DIRECTORY libdem/data/ DESTINATION ${shared_files}/materials)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/contact)
install(EXPORT contact NAMESPACE contact:: DESTINATION ${package_folder})
configure_package_config_file(cmake/contactConfig.cmake.in ${CMAKE_BINARY_DIR}/contactConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/contactConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/contactConfig.cmake ${CMAKE_BINARY_DIR}/contactConfigVersion.cmake
        DESTINATION ${package_folder})
list(TRANSFORM independent_definitions PREPEND " -D" OUTPUT_VARIABLE independent_flags)
list(JOIN independent_flags "" independent_flags)
configure_file(cmake/contact.pc.in ${CMAKE_BINARY_DIR}/contact.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/contact.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
