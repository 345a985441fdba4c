# SPDX-License-Identifier: BSD-3-Clause
# What a plugin outside of the tree is built with (docs/adr/0144): the headers, the target
# relievo::plugins_api by find_package(relievo COMPONENTS plugins), and the example as a project of
# its own. Included by plugins/api.
include(CMakePackageConfigHelpers)

# plugin.h and what it includes, no more: a test walks the #includes.
set(relievo_interface_headers
  plugins/api/host.h plugins/api/plugin.h
  core/base/grid.h core/base/origin.h core/base/vec3.h
  core/recording/force_point.h
  core/region/probe.h core/region/region_window.h core/region/square.h)
set(relievo_include_dir ${CMAKE_INSTALL_INCLUDEDIR}/relievo)
foreach(header IN LISTS relievo_interface_headers)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${CMAKE_SOURCE_DIR}/${header} DESTINATION ${relievo_include_dir}/${folder}
    COMPONENT dev)
endforeach()

target_compile_features(relievo_plugins_api INTERFACE cxx_std_20)
set_target_properties(relievo_plugins_api PROPERTIES EXPORT_NAME plugins_api)
install(TARGETS relievo_plugins_api EXPORT relievo
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/relievo COMPONENT window
  INCLUDES DESTINATION ${relievo_include_dir})

set(relievo_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/relievo)
install(EXPORT relievo NAMESPACE relievo:: FILE relievoTargets.cmake
  DESTINATION ${relievo_config_dir} COMPONENT dev)
file(STRINGS ${CMAKE_SOURCE_DIR}/plugins/api/plugin.h relievo_plugin_version
  REGEX "^#define RELIEVO_PLUGIN_VERSION ")
string(REGEX REPLACE ".*\"(.*)\".*" "\\1" relievo_plugin_version "${relievo_plugin_version}")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/plugins/api/plugin.h)
set(relievo_plugin_dir ${CMAKE_INSTALL_LIBDIR}/relievo/plugins)
configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/relievoConfig.cmake.in
  ${CMAKE_BINARY_DIR}/generated/relievoConfig.cmake
  INSTALL_DESTINATION ${relievo_config_dir} PATH_VARS relievo_plugin_dir
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/relievoConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/generated/relievoConfig.cmake
  ${CMAKE_BINARY_DIR}/generated/relievoConfigVersion.cmake
  DESTINATION ${relievo_config_dir} COMPONENT dev)

install(DIRECTORY ${CMAKE_SOURCE_DIR}/plugins/example/
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/relievo-dev/examples/plugin COMPONENT dev)
