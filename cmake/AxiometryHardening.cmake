# What makes an error in a program hard to use for an attacker: the one place. tests/hardening_check.py reads the built
# program and proves it. Flags for the compiler are not among it yet.
include(CheckPIESupported)
check_pie_supported()

# axiometry_hardened(TARGET): the program lies at random addresses (PIE), all its symbols are bound when it starts and
# their table is read-only from then on (full RELRO), and no stack is executable.
function(axiometry_hardened target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    target_link_options(${target} PRIVATE -Wl,-z,relro,-z,now -Wl,-z,noexecstack)
  endif()
endfunction()
