# SPDX-License-Identifier: BSD-3-Clause
# The linker to use instead of the compiler's own. Some 350 test programs are linked anew when a
# library changes; gold, which binutils brings along, needs less than a third of the time for one.
set(RELIEVO_LINKER "" CACHE STRING "Linker to use, as -fuse-ld takes it (gold, lld, mold); empty is the compiler's own")

if(RELIEVO_LINKER)
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=${RELIEVO_LINKER} RELIEVO_HAS_LINKER_${RELIEVO_LINKER})
  if(RELIEVO_HAS_LINKER_${RELIEVO_LINKER})
    add_link_options(-fuse-ld=${RELIEVO_LINKER})
  else()
    message(WARNING "The linker ${RELIEVO_LINKER} is not installed; the compiler's own links, which takes longer.")
  endif()
endif()
