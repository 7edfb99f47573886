# lib${name}.so, which is installed: the objects of the archive that everything in this tree links.
include(GNUInstallDirs)
if(NOT EXISTS ${CMAKE_BINARY_DIR}/nothing.cpp)
  file(WRITE ${CMAKE_BINARY_DIR}/nothing.cpp "")
endif()
function(shared_library name archive)
  add_library(${name}_shared SHARED ${CMAKE_BINARY_DIR}/nothing.cpp)
  set_target_properties(
    ${name}_shared
    PROPERTIES OUTPUT_NAME ${name}
               EXPORT_NAME ${name}
               VERSION ${PROJECT_VERSION}
               SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
               LINK_DEPENDS $<TARGET_FILE:${archive}>)
  add_dependencies(${name}_shared ${archive})
  target_link_options(${name}_shared PRIVATE LINKER:--whole-archive $<TARGET_FILE:${archive}> LINKER:--no-whole-archive
                      LINKER:--no-undefined)
  target_compile_features(${name}_shared INTERFACE cxx_std_20)
  # Bits must not depend on contraction: what is inlined from the headers is compiled as the libraries are.
  target_compile_options(${name}_shared INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>)
  target_include_directories(${name}_shared INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  install(
    TARGETS ${name}_shared
    EXPORT contact
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endfunction()
