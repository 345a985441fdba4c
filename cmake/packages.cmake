# SPDX-License-Identifier: BSD-3-Clause
# Debian packages (docs/adr/0152): `cmake --preset package`, `cmake --build --preset package`, and
# `cpack` there. Two builds of one commit give equal bytes where SOURCE_DATE_EPOCH is set.
set(RELIEVO_MAINTAINER "The relievo authors <relievo@relievo.invalid>" CACHE STRING
  "Who answers for the packages: name and address")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME relievo)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL cli)
if(RELIEVO_BUILD_UI)
  list(APPEND CPACK_COMPONENTS_ALL draw window)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${RELIEVO_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})

set(CPACK_DEBIAN_CLI_PACKAGE_NAME relievo-cli)
set(CPACK_COMPONENT_CLI_DESCRIPTION "inspect and touch scans of heritage objects, command line
A scan of a coin, a relief, a statue or a site becomes a depth map and its
Gaussian pyramid; regions of it are measured, drawn, and touched along strokes
with the force of a haptic device at 1 kHz. Scans are read in a process of
their own.

This package has all commands and no window; those that draw need the package
relievo-draw. Its udev rule gives whoever sits at the computer access to a
Novint Falcon, to devices of Force Dimension, to a SpaceMouse, and to
joysticks, gamepads, button boxes and foot switches that count as one. An
empty file /etc/udev/rules.d/60-relievo-falcon.rules takes it back.")
# libusb and hidapi are loaded where they are.
set(CPACK_DEBIAN_CLI_PACKAGE_RECOMMENDS "libhidapi-hidraw0, libusb-1.0-0, relievo-draw (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_CLI_PACKAGE_SUGGESTS "relievo")

# What brings Qt's widgets and VTK, apart, for computers that draw nothing.
set(CPACK_DEBIAN_DRAW_PACKAGE_NAME relievo-draw)
set(CPACK_COMPONENT_DRAW_DESCRIPTION "pictures, figures and videos of scans of heritage objects
The commands of relievo that draw: relief images in many looks, figures for
print with scales and what was not measured, anaglyphs and other stereo
pictures, and videos of recorded touches.")
set(CPACK_DEBIAN_DRAW_PACKAGE_DEPENDS "relievo-cli (= ${PROJECT_VERSION})")
# Pictures are drawn on a screen in memory where there is none, and videos are packed by ffmpeg.
set(CPACK_DEBIAN_DRAW_PACKAGE_RECOMMENDS "fonts-dejavu-core, libgl1-mesa-dri, xvfb")
set(CPACK_DEBIAN_DRAW_PACKAGE_SUGGESTS "ffmpeg")

set(CPACK_DEBIAN_WINDOW_PACKAGE_NAME relievo)
set(CPACK_COMPONENT_WINDOW_DESCRIPTION "feel and see scanned heritage at every scale
relievo opens a scan of a coin, a relief, a statue or a site, shows it in
stereo, and lets it be touched with a haptic device or a mouse, at any scale.
Measurements carry their uncertainty; recordings can be replayed and verified;
figures say how they were made.")
set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS
  "relievo-draw (= ${PROJECT_VERSION}), fonts-dejavu-core, libqt5svg5")
set(CPACK_DEBIAN_WINDOW_PACKAGE_RECOMMENDS "ffmpeg, fonts-lohit-deva, libgl1-mesa-dri, libpulse0, qttranslations5-l10n, speech-dispatcher | espeak-ng, xdg-utils")
set(CPACK_DEBIAN_WINDOW_PACKAGE_SUGGESTS "www-browser")

# For plugins outside of the tree (docs/adr/0144).
if(RELIEVO_BUILD_UI)
  list(APPEND CPACK_COMPONENTS_ALL dev)
  set(CPACK_DEBIAN_DEV_PACKAGE_NAME relievo-dev)
  set(CPACK_COMPONENT_DEV_DESCRIPTION "build plugins for relievo
A plugin of relievo adds panels and commands to its window, hears which
part of a scan is shown, and shows where a hand is on it. A plugin for a
haptic device, in C, drives one that relievo does not know.

This package has the headers, the files for CMake's find_package(), and an
example of each as a project of its own.")
  set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "relievo (= ${PROJECT_VERSION}), qtbase5-dev")
endif()

# What makes maps by several processes, where MPI is there (docs/adr/0232).
if(RELIEVO_CLUSTER)
  list(APPEND CPACK_COMPONENTS_ALL tiles)
  set(CPACK_DEBIAN_TILES_PACKAGE_NAME relievo-tiles)
  set(CPACK_COMPONENT_TILES_DESCRIPTION "depth maps of large sites by several processes
A scan of a site becomes a depth map and its Gaussian pyramid by tiles, within
a limit of memory, made by several processes of one machine or of a cluster
that MPI or a scheduler starts. The files are those of the command line
relievo, to the last bit; work that was stopped goes on.")
  set(CPACK_DEBIAN_TILES_PACKAGE_DEPENDS "relievo-cli (= ${PROJECT_VERSION}), openmpi-bin")
endif()

# The Python package, where it is built (docs/adr/0148).
if(RELIEVO_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-relievo)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "scans of heritage objects as NumPy arrays
Opens scans of coins, reliefs and sites as depth maps, makes Gaussian
pyramids and windows of them, touches them along strokes with the force of
a haptic device, reads recordings and draws pictures: the numbers of the
command line relievo, to the last bit.")
  # The extension is built for one Python, and starts the programs of one version.
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "relievo-cli (= ${PROJECT_VERSION}), python3-numpy, python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${next_minor}~)")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "relievo-draw (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-ipykernel, jupyter-notebook")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/app/python/package/postinst
    ${CMAKE_SOURCE_DIR}/app/python/package/prerm)
endif()

# What Debian wants of every package: who may do what with it, and what changed.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
    RENAME copyright COMPONENT ${component})
  install(FILES ${CMAKE_BINARY_DIR}/generated/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endforeach()
find_program(GZIP_PROGRAM gzip REQUIRED)
# -n: without its time, so that two builds give the same bytes.
configure_file(CHANGELOG.md ${CMAKE_BINARY_DIR}/generated/changelog COPYONLY)
execute_process(COMMAND ${GZIP_PROGRAM} -9 -n -k -f changelog
  WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/generated COMMAND_ERROR_IS_FATAL ANY)

include(CPack)
