# What makes an error in a program hard to use for an attacker: the one place. tests/hardening_check.py reads the built
# program and proves it.
include(CheckPIESupported)
check_pie_supported()

# axiometry_hardened_code(): for every source. A canary before each return address, a probe of each page of a large stack
# frame, the C library's functions that know the size of what they write to, and, where the processor can, marks of where
# an indirect jump may go (CET: IBT and shadow stack). The sanitizers find more than the fortified functions do, and do
# not go with them.
function(axiometry_hardened_code)
  set(flags -fstack-protector-strong)
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    list(APPEND flags -fstack-clash-protection)
  endif()
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    list(APPEND flags -fcf-protection=full)
  elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
    list(APPEND flags -mbranch-protection=standard)
  endif()
  add_compile_options(${flags})
  if(NOT AXIOMETRY_SANITIZE AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug") # fortifying needs an optimising compiler
    add_compile_options(-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3)
  endif()
endfunction()

# axiometry_hardened(TARGET): the program lies at random addresses (PIE), all its symbols are bound when it starts and
# their table is read-only from then on (full RELRO), and no stack is executable.
function(axiometry_hardened target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    target_link_options(${target} PRIVATE -Wl,-z,relro,-z,now -Wl,-z,noexecstack)
  endif()
endfunction()
