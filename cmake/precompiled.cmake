# SPDX-License-Identifier: BSD-3-Clause
# What nearly every source includes, compiled once before them: docs/adr/0224. The presets that make
# packages and look for faults do without, so that a source which forgets an include is found.
option(RELIEVO_PRECOMPILE "Compile what most sources include once, before them" OFF)

set(relievo_precompiled_std <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <filesystem> <fstream>
  <functional> <future> <iterator> <limits> <map> <memory> <mutex> <numeric> <optional> <random> <set> <span>
  <sstream> <string> <string_view> <thread> <utility> <vector>)
set(relievo_precompiled_gtest ${relievo_precompiled_std} <gtest/gtest.h> <gmock/gmock.h>)
set(relievo_precompiled_qt ${relievo_precompiled_gtest} <QAction> <QApplication> <QComboBox> <QDir>
  <QDoubleSpinBox> <QFile> <QLabel> <QPushButton> <QSignalSpy> <QtTest/QTest>)

# Adds the target whose headers the others of its kind use. Programs and libraries differ: the
# compiler takes such headers only where its own options are those that they were made with.
function(relievo_add_precompiled kind type)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINK;OPTIONS" ${ARGN})
  set(source ${CMAKE_BINARY_DIR}/precompiled/${kind}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "int main() {}\n")
  if(type STREQUAL "program")
    add_executable(relievo_precompiled_${kind} EXCLUDE_FROM_ALL ${source})
    set_target_properties(relievo_precompiled_${kind} PROPERTIES
      RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/precompiled)
  else()
    add_library(relievo_precompiled_${kind} OBJECT EXCLUDE_FROM_ALL ${source})
  endif()
  target_link_libraries(relievo_precompiled_${kind} PRIVATE relievo_settings ${ARG_LINK})
  target_compile_options(relievo_precompiled_${kind} PRIVATE ${ARG_OPTIONS})
  target_precompile_headers(relievo_precompiled_${kind} PRIVATE ${ARG_HEADERS})
endfunction()

# relievo_precompile(target kind): kind is module, test or gui_test.
function(relievo_precompile target kind)
  if(RELIEVO_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM relievo_precompiled_${kind})
  endif()
endfunction()

# A test that is linked with `libraries`: those with Qt are compiled with its options, too.
function(relievo_precompile_test target libraries)
  if(NOT RELIEVO_PRECOMPILE)
    return()
  endif()
  if("${libraries}" MATCHES "gui_fixture|relievo::ui(;|$)|relievo::ui_message|relievo::plugins|Qt5::")
    target_link_libraries(${target} PRIVATE Qt5::Widgets Qt5::Test)
    relievo_precompile(${target} gui_test)
  else()
    relievo_precompile(${target} test)
  endif()
endfunction()

# Tests are compiled more often than they are run, and what they test is compiled as it is released.
set(relievo_test_options $<$<CONFIG:Release>:-O1>)

if(RELIEVO_PRECOMPILE)
  relievo_add_precompiled(module library HEADERS ${relievo_precompiled_std})
  if(RELIEVO_BUILD_TESTS)
    relievo_add_precompiled(test program HEADERS ${relievo_precompiled_gtest}
      LINK GTest::gtest GTest::gmock OPTIONS ${relievo_test_options})
    if(RELIEVO_BUILD_UI)
      relievo_add_precompiled(gui_test program HEADERS ${relievo_precompiled_qt}
        LINK Qt5::Widgets Qt5::Test GTest::gtest GTest::gmock OPTIONS ${relievo_test_options})
    endif()
  endif()
endif()
