# SPDX-License-Identifier: BSD-3-Clause
# Run at every build, as a script: writes the commit that is being built into a header, and
# touches it only if it changed. cmake -D SOURCE=... -D HEADER=... -P WriteCommit.cmake
find_program(git git)
set(commit unknown)
if(git)
  execute_process(COMMAND ${git} -C ${SOURCE} describe --always --abbrev=40 --exclude=* --dirty=-changed
    OUTPUT_VARIABLE said ERROR_QUIET RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE)
  # A release unpacked inside somebody else's repository is not that repository's commit.
  execute_process(COMMAND ${git} -C ${SOURCE} ls-files --error-unmatch cmake/WriteCommit.cmake
    OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE foreign)
  if(NOT failed AND NOT foreign)
    set(commit ${said})
  endif()
endif()
set(text "// Made by cmake/WriteCommit.cmake.\n#pragma once\n\nnamespace relievo {\ninline constexpr const char* kCommit = \"${commit}\";\n}\n")
if(EXISTS ${HEADER})
  file(READ ${HEADER} before)
endif()
if(NOT before STREQUAL text)
  file(WRITE ${HEADER} "${text}")
endif()
