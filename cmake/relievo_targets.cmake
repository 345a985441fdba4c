# SPDX-License-Identifier: BSD-3-Clause
# One helper to add a library, one to add a test; every target goes through them.

add_library(relievo_settings INTERFACE)
target_include_directories(relievo_settings INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(relievo_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual
  $<$<BOOL:${RELIEVO_WARNINGS_AS_ERRORS}>:-Werror>)
target_compile_definitions(relievo_settings INTERFACE QT_NO_KEYWORDS QT_NO_CAST_TO_ASCII
  RELIEVO_VERSION_STRING="${PROJECT_VERSION}")

include(together)
include(precompiled)

# relievo_add_module(core_depth SOURCES a.cpp ... PUBLIC targets... PRIVATE targets... [QT] [TOGETHER])
# One module folder, one target: relievo_core_depth, alias relievo::core_depth.
function(relievo_add_module name)
  cmake_parse_arguments(ARG "QT;TOGETHER" "TYPE" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  if(NOT ARG_SOURCES)
    add_library(relievo_${name} INTERFACE)
    target_link_libraries(relievo_${name} INTERFACE relievo_settings ${ARG_PUBLIC})
  else()
    if(NOT ARG_TYPE)
      set(ARG_TYPE STATIC)
    endif()
    add_library(relievo_${name} ${ARG_TYPE} ${ARG_SOURCES})
    target_link_libraries(relievo_${name} PUBLIC $<BUILD_INTERFACE:relievo_settings> ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    if(ARG_QT)
      set_target_properties(relievo_${name} PROPERTIES AUTOMOC ON AUTORCC ON)
    endif()
    if(ARG_TOGETHER)
      relievo_compile_together(relievo_${name})
    elseif(NOT ARG_QT AND ARG_TYPE STREQUAL "STATIC")
      relievo_precompile(relievo_${name} module)
    endif()
  endif()
  add_library(relievo::${name} ALIAS relievo_${name})
endfunction()

# What kind of test the path says: the word for `ctest -L`.
#   e2e     whole programs: the command line, the window, Python, pages, what is installed
#   gui     parts of the window and pictures; has a screen of its own
#   device  a device, emulated or mocked
#   fast    all else: functions, without a screen
function(relievo_kind_of_test path is_drawn result)
  if(path MATCHES "^(app|hostile|docs|manual)/")
    set(kind e2e)
  elseif(path MATCHES "^emulator/|^haptics/device/|falcon|device")
    set(kind device)
  elseif(is_drawn OR path MATCHES "^ui/")
    set(kind gui)
  else()
    set(kind fast)
  endif()
  set(${result} ${kind} PARENT_SCOPE)
endfunction()

# relievo_add_test(core/depth/rules/rasterize_test LINK targets... [DISPLAY] [QT] [MAIN] [LABELS ...])
# One test file tests/<path>.cpp, one executable, one CTest entry of the same name.
# DISPLAY: needs an X display, and gets one of its own. MAIN: it has a main() of its own, in the
# file or among SOURCES. OPTIMISED: compiled as what it tests is, because g++ 12 warns wrongly else.
function(relievo_add_test path)
  cmake_parse_arguments(ARG "DISPLAY;QT;MAIN;OPTIMISED" "TIMEOUT" "LINK;SOURCES;LABELS;ENVIRONMENT" ${ARGN})
  string(REPLACE "/" "_" target ${path})
  add_executable(${target} ${CMAKE_SOURCE_DIR}/tests/${path}.cpp ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE relievo_settings ${ARG_LINK} GTest::gtest GTest::gmock)
  if(NOT ARG_MAIN)
    target_link_libraries(${target} PRIVATE GTest::gtest_main)
  endif()
  target_compile_definitions(${target} PRIVATE
    RELIEVO_SOURCE_DIR="${CMAKE_SOURCE_DIR}" RELIEVO_BINARY_DIR="${CMAKE_BINARY_DIR}")
  if(NOT ARG_OPTIMISED)
    target_compile_options(${target} PRIVATE ${relievo_test_options})
    relievo_precompile_test(${target} "${ARG_LINK}")
  endif()
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  if(ARG_QT)
    set_target_properties(${target} PROPERTIES AUTOMOC ON)
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 900)  # For what hangs: a busy machine is no failure.
  endif()
  set(own_screen)
  if(ARG_DISPLAY)
    set(own_screen ${CMAKE_SOURCE_DIR}/tests/own_screen)
  endif()
  add_test(NAME ${path} COMMAND ${own_screen} $<TARGET_FILE:${target}>)
  set_tests_properties(${path} PROPERTIES TIMEOUT ${ARG_TIMEOUT})
  if(ARG_DISPLAY)
    list(APPEND ARG_LABELS display)
  endif()
  relievo_kind_of_test(${path} "${ARG_DISPLAY}" kind)
  list(APPEND ARG_LABELS ${kind})
  set_tests_properties(${path} PROPERTIES LABELS "${ARG_LABELS}")
  # Nobody listens there: a service of this computer's own is no part of a test.
  list(PREPEND ARG_ENVIRONMENT RELIEVO_HAPLY_SERVICE=1)
  set_tests_properties(${path} PROPERTIES ENVIRONMENT "${ARG_ENVIRONMENT}")
endfunction()
