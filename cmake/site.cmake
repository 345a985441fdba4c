# SPDX-License-Identifier: BSD-3-Clause
# The pages as a site (docs/adr/0153): target `site`, part of `all`. ./run builds the programs alone
# and does without. Where Debian's Sphinx or MyST is missing nothing is made, and that is said.
find_program(RELIEVO_SITE_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(NOT RELIEVO_SITE_PYTHON)
  set(RELIEVO_SITE_PYTHON python3)
endif()
set(relievo_site ${CMAKE_BINARY_DIR}/site)
file(GLOB_RECURSE relievo_pages CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/docs/*)
add_custom_command(OUTPUT ${relievo_site}/html/index.html
  COMMAND ${RELIEVO_SITE_PYTHON} ${CMAKE_SOURCE_DIR}/docs/site/build ${relievo_site}
  DEPENDS ${relievo_pages} ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/CONTRIBUTING.md
          ${CMAKE_SOURCE_DIR}/CHANGELOG.md ${CMAKE_SOURCE_DIR}/CMakeLists.txt
  DEPFILE ${relievo_site}/site.d
  COMMENT "The pages as a site" VERBATIM)
add_custom_target(site ALL DEPENDS ${relievo_site}/html/index.html)
# Nothing is installed where nothing was made.
install(DIRECTORY ${relievo_site}/html DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT window OPTIONAL)
