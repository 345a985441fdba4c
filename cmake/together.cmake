# SPDX-License-Identifier: BSD-3-Clause
# Sources of a module compiled eight by eight: what they all include and instantiate is compiled once
# for eight. A build from nothing spent most of its time on that, again and again. The presets that
# make packages and look for faults do without, so that a source which forgets an include is found.
option(RELIEVO_COMPILE_TOGETHER "Compile the sources of the largest modules eight by eight" OFF)

function(relievo_compile_together target)
  if(NOT RELIEVO_COMPILE_TOGETHER)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  # A class that only its own source knows may hold what only this source knows.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# Sources with names of their own that another source of their module has, too.
function(relievo_compile_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
