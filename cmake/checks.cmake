# SPDX-License-Identifier: BSD-3-Clause
# Checks that look at sources rather than run them. None is part of the default build; each is a
# target: cmake --build --preset release --target format | format-check | tidy | check_headers

set(relievo_folders core haptics plugins ui app data tests)
set(relievo_patterns ${relievo_folders})
list(TRANSFORM relievo_patterns APPEND "/**.h" OUTPUT_VARIABLE relievo_header_patterns)
list(TRANSFORM relievo_patterns APPEND "/**.cpp" OUTPUT_VARIABLE relievo_cpp_patterns)

# clang-format 14, as in .clang-format.
set(format_files git -C ${CMAKE_SOURCE_DIR} ls-files -z ${relievo_header_patterns}
    ${relievo_cpp_patterns})
add_custom_target(format
  COMMAND ${format_files} | xargs -0 clang-format -i
  WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} VERBATIM)
add_custom_target(format-check
  COMMAND ${format_files} | xargs -0 clang-format --dry-run --Werror
  WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} VERBATIM)

# clang-tidy 14 over everything, from the compile database. Build first: it needs the moc files.
# Headers that g++ has precompiled are nothing to clang.
list(JOIN relievo_folders "|" relievo_folder_pattern)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/tidy)
add_custom_target(tidy
  COMMAND sed "s: -Winvalid-pch -include [^ ]*/cmake_pch.hxx::" compile_commands.json > tidy/compile_commands.json
  COMMAND run-clang-tidy -quiet -p ${CMAKE_BINARY_DIR}/tidy
          "${CMAKE_SOURCE_DIR}/(${relievo_folder_pattern})/"
  WORKING_DIRECTORY ${CMAKE_BINARY_DIR} USES_TERMINAL VERBATIM)

# Each header compiled alone: it must include what it uses.
set(header_sources)
foreach(folder IN LISTS relievo_folders)
  file(GLOB_RECURSE headers RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS ${folder}/*.h)
  if(NOT RELIEVO_PYTHON)
    list(FILTER headers EXCLUDE REGEX "^app/python/")
  endif()
  foreach(header IN LISTS headers)
    set(source ${CMAKE_BINARY_DIR}/check_headers/${header}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"\n")
    list(APPEND header_sources ${source})
  endforeach()
endforeach()
add_library(check_headers OBJECT EXCLUDE_FROM_ALL ${header_sources})
target_link_libraries(check_headers PRIVATE relievo_settings Qt5::Widgets Qt5::Test
  nlohmann_json::nlohmann_json relievo::qwt PkgConfig::LIBUSB PkgConfig::HIDAPI
  ${RELIEVO_VTK_LIBRARIES})
if(RELIEVO_PYTHON)
  target_link_libraries(check_headers PRIVATE pybind11::module)
endif()
if(RELIEVO_BUILD_TESTS)
  target_link_libraries(check_headers PRIVATE GTest::gtest GTest::gmock)
  target_compile_definitions(check_headers PRIVATE
    RELIEVO_SOURCE_DIR="${CMAKE_SOURCE_DIR}" RELIEVO_BINARY_DIR="${CMAKE_BINARY_DIR}")
endif()
