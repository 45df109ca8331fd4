# Compiler settings shared by every target of the project.
function(axiometry_settings)
  set(CMAKE_CXX_STANDARD 23 PARENT_SCOPE)
  set(CMAKE_CXX_STANDARD_REQUIRED ON PARENT_SCOPE)
  set(CMAKE_CXX_EXTENSIONS OFF PARENT_SCOPE)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON PARENT_SCOPE)
  if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release PARENT_SCOPE)
  endif()
  find_program(CCACHE ccache)
  if(CCACHE)
    # What was compiled is found again by the contents of all it included, not by its preprocessed text: a header of
    # which only a comment differs would give an older precompiled header back, in which g++ does not find the header of
    # now, and includes it twice. In a namespace of their own, so that no entry made otherwise is taken.
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_DEPEND=1 CCACHE_NAMESPACE=axiometry-by-contents
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE} PARENT_SCOPE)
  endif()
  add_compile_options(-Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Werror=return-type
                      -Werror=format -Werror=format-security
                      -Wno-missing-field-initializers) # what designated initialisers leave out is as its type begins
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-Werror=conversion -Werror=return-local-addr)
    # False positives of g++ 12: in fmt 9, in strings that are put together, once memcpy() is fortified, and of what
    # std::expected and std::optional hold.
    add_compile_options(-Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict -Wno-array-bounds
                        -Wno-maybe-uninitialized)
    # Where there is memory enough, the compiler does not search its memory for what it needs no more: a unit takes a
    # fifth more of it, and up to a quarter less time (docs/performance.md).
    cmake_host_system_information(RESULT memory_mib QUERY TOTAL_PHYSICAL_MEMORY)
    cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
    math(EXPR memory_mib_per_core "${memory_mib} / ${cores}")
    if(memory_mib_per_core GREATER_EQUAL 3000)
      add_compile_options($<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=1048576>)
    endif()
  elseif(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # Of the standard library of g++ 12: what its stable_sort() takes for its buffer. And inner braces of arrays.
    add_compile_options(-Wno-deprecated-declarations -Wno-missing-braces)
  endif()
  if(AXIOMETRY_SANITIZE)
    add_compile_options(-fsanitize=${AXIOMETRY_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${AXIOMETRY_SANITIZE})
    # What the sanitizers add is much to link: a fifth of the time where the linker of LLVM is there.
    find_program(LLD NAMES ld.lld HINTS /usr/lib/llvm-19/bin)
    if(LLD AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
      add_link_options(-fuse-ld=lld)
    endif()
  endif()
endfunction()

# base/version.h from the project's version.
function(axiometry_version_header)
  configure_file(${PROJECT_SOURCE_DIR}/src/axiometry/base/version.h.in
                 ${PROJECT_BINARY_DIR}/generated/axiometry/base/version.h @ONLY)
endfunction()

# axiometry_library(TARGET EXPORT_NAME FOLDER...): a library of all sources in and below these folders of src/axiometry,
# without tests (*_test.cpp) and benchmarks (*_bench.cpp); static, or shared with BUILD_SHARED_LIBS. Of a shared one the
# name holds MAJOR.MINOR: within these a program needs no new build (docs/howto/use-as-a-library.md). Its objects are
# those of a static one, without a macro of its own, so that changing the option compiles nothing anew.
function(axiometry_library target export_name)
  add_library(${target})
  add_library(axiometry::${export_name} ALIAS ${target})
  set_target_properties(
    ${target} PROPERTIES EXPORT_NAME ${export_name} POSITION_INDEPENDENT_CODE ON DEFINE_SYMBOL ""
                         VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  if(BUILD_SHARED_LIBS AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
    set(symbols ${PROJECT_SOURCE_DIR}/cmake/exported_symbols.map)
    target_link_options(${target} PRIVATE -Wl,--version-script=${symbols} -Wl,-z,relro,-z,now -Wl,-z,noexecstack)
    set_target_properties(${target} PROPERTIES LINK_DEPENDS ${symbols})
  endif()
  axiometry_sources(${target} ${ARGN})
endfunction()

# axiometry_objects(TARGET LIBRARY FOLDER...): the sources of these folders, which are compiled in a way of their own, as
# a part of that library.
function(axiometry_objects target library)
  add_library(${target} OBJECT)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  axiometry_sources(${target} ${ARGN})
  target_sources(${library} PRIVATE $<TARGET_OBJECTS:${target}>)
endfunction()

# axiometry_sources(TARGET FOLDER...): what axiometry_library() and axiometry_objects() have in common.
function(axiometry_sources target)
  foreach(folder IN LISTS ARGN)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/axiometry/${folder}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "_(test|bench)\\.cpp$")
    target_sources(${target} PRIVATE ${sources})
  endforeach()
  target_include_directories(
    ${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
                     $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} PUBLIC cxx_std_23)
endfunction()

# axiometry_lightly_optimised(TARGET): for what reads, writes, formats and waits. It runs as fast as with -O3 and is
# compiled in three quarters of the time (docs/performance.md); what computes is in axiometry::core. Under the sanitizers
# not at all: a third of the time.
function(axiometry_lightly_optimised target)
  if(AXIOMETRY_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  else()
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# axiometry_unity_build(TARGET [HEADERS header...] [HEADERS_OF other] [TOGETHER "folder..."...]): compiles once what is
# common: the headers that most sources of the target include, and these; and the sources of each folder as one, so that
# a template is instantiated once for all of them. For that a name of an anonymous namespace stands for one thing in its
# folder; where each source has the same names, such as the read() of every format, they are in a namespace with the name
# of the source. Small folders are compiled TOGETHER, those of each string as one, since most of the work of a unit is its
# headers; in these a name stands for one thing in all of them. A source that has a UNITY_GROUP keeps it. HEADERS_OF takes
# the headers that are compiled for another target, whose level of optimisation must be that of this one: g++ 12 crashes
# with those of another level. Sources never rely on any of it: without the option it does nothing.
function(axiometry_unity_build target)
  if(NOT AXIOMETRY_UNITY_BUILD)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADERS_OF" "HEADERS;TOGETHER")
  if(arg_HEADERS_OF)
    target_precompile_headers(${target} REUSE_FROM ${arg_HEADERS_OF})
    target_compile_options(${target} PRIVATE -fPIC -pthread) # as the headers were compiled
  else()
    target_precompile_headers(
      ${target} PRIVATE <algorithm> <array> <cmath> <expected> <functional> <map> <optional> <span> <sstream> <string>
      <string_view> <variant> <vector> <fmt/format.h> ${PROJECT_SOURCE_DIR}/src/axiometry/model/test.h
      ${PROJECT_SOURCE_DIR}/src/axiometry/base/json/json.h ${arg_HEADERS})
  endif()
  if(AXIOMETRY_UNITY_BUILD STREQUAL "HEADERS") # the shortest wait after an edit
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # What is said of names of the file before, and of headers, which these sources are not.
  target_compile_options(${target} PRIVATE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} ABSOLUTE)
    get_filename_component(folder ${folder} DIRECTORY)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
    get_source_file_property(group ${source} UNITY_GROUP)
    if(source MATCHES "\\.cpp$" AND folder MATCHES "^(src|apps|tests)" AND NOT group)
      string(MAKE_C_IDENTIFIER ${folder} group)
      string(REGEX REPLACE "^(src/axiometry|apps)/" "" room ${folder})
      foreach(folders IN LISTS arg_TOGETHER)
        separate_arguments(folders)
        if(room IN_LIST folders)
          list(GET folders 0 first)
          string(MAKE_C_IDENTIFIER ${first}_and_more group)
        endif()
      endforeach()
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
endfunction()

# axiometry_descriptor_table(TARGET FOLDER TYPE HEADER): every .cpp in and below the folder that contains a line
# `extern const TYPE <stem>_...`-style definition `const TYPE <stem> = {` or `const TYPE <stem>{` is
# listed in a generated source that defines `std::span<const TYPE* const> TYPE_table()`. No
# self-registering globals: a linker would drop them from a static library.
function(axiometry_descriptor_table target folder type header)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/axiometry/${folder}/*.cpp)
  list(SORT sources COMPARE FILE_BASENAME) # whichever room they are in
  string(REGEX REPLACE "([a-z])([A-Z])" "\\1_\\2" lower ${type})
  string(TOLOWER ${lower} lower)
  set(declarations "")
  set(entries "")
  foreach(source IN LISTS sources)
    get_filename_component(stem ${source} NAME_WE)
    file(STRINGS ${source} definition REGEX "^const ${type} ${stem}_${lower}( =|{)")
    if(definition)
      string(APPEND declarations "extern const ${type} ${stem}_${lower};\n")
      string(APPEND entries "    &${stem}_${lower},\n")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    endif()
  endforeach()
  string(REPLACE "/" "_" stem ${folder})
  string(REGEX REPLACE "/.*" "" namespace ${folder})
  set(output ${PROJECT_BINARY_DIR}/generated/${stem}_table.cpp)
  file(CONFIGURE OUTPUT ${output} CONTENT
"// Generated by CMake from the sources in src/axiometry/${folder}.
#include \"${header}\"

namespace axiometry::${namespace} {

${declarations}
namespace {
constexpr const ${type}* all_of_${lower}[] = {
${entries}    nullptr,  // a folder may be empty, an array may not
};
}

std::span<const ${type}* const> ${lower}_table() { return std::span(all_of_${lower}).first(std::size(all_of_${lower}) - 1); }

}  // namespace axiometry::${namespace}
" @ONLY)
  set_source_files_properties(${output} PROPERTIES UNITY_GROUP descriptor_tables)
  target_sources(${target} PRIVATE ${output})
endfunction()

# axiometry_vector_kernels(TARGET STEM...): compiles src/axiometry/STEM.h once for every vector target of the
# processor family (src/axiometry/numeric/vector_target.h says which and why). Nothing may be contracted to a fused
# operation, in any of them: the bits must not depend on the target.
function(axiometry_vector_kernels target)
  set(flags_plain "")
  set(flags_avx2 -mavx2)
  set(flags_avx512 -mavx512f -mavx512bw -mavx512dq -mavx512vl)
  set(flags_all -ffp-contract=off)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND flags_all -fschedule-insns -fsched-pressure) # off by default on x86, where registers are few
  endif()
  set(vector_targets plain)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$" AND CMAKE_SIZEOF_VOID_P EQUAL 8)
    list(APPEND vector_targets avx2 avx512)
    target_compile_definitions(${target} PRIVATE AXIOMETRY_X86_KERNELS)
  endif()
  set(stems "")
  foreach(kernel IN LISTS ARGN)
    string(REPLACE "/" "_" stem ${kernel})
    if(AXIOMETRY_UNITY_BUILD STREQUAL "ON") # all of a target as one: their headers take longer than they
      set(stem kernels)
    endif()
    list(APPEND stems ${stem})
    string(APPEND includes_${stem} "#include \"axiometry/${kernel}.h\"\n")
  endforeach()
  list(REMOVE_DUPLICATES stems)
  foreach(stem IN LISTS stems)
    foreach(vector_target IN LISTS vector_targets)
      set(source ${PROJECT_BINARY_DIR}/generated/${stem}_${vector_target}.cpp)
      file(CONFIGURE OUTPUT ${source} CONTENT "// Generated by CMake.\n${includes_${stem}}" @ONLY)
      set_source_files_properties(
        ${source} PROPERTIES COMPILE_DEFINITIONS AXIOMETRY_VECTOR_TARGET=${vector_target}
                             COMPILE_OPTIONS "${flags_${vector_target}};${flags_all}"
                             SKIP_PRECOMPILE_HEADERS ON)
      target_sources(${target} PRIVATE ${source})
    endforeach()
  endforeach()
endfunction()

# axiometry_embed(TARGET NAMESPACE NAME FILE-OR-PATTERN...): the bytes of these files as
# `std::span<const EmbeddedFile> NAME_files()` of axiometry::NAMESPACE, in the order of their names
# (src/axiometry/base/embedded_file.h). The assembler takes the bytes as they are: no text, no limit, no time.
function(axiometry_embed target namespace name)
  file(GLOB files CONFIGURE_DEPENDS ${ARGN})
  list(SORT files COMPARE FILE_BASENAME)
  # The note of cet.h says that no indirect jump is here; without it the whole program would lose that mark.
  set(assembly "#if defined __CET__\n#include <cet.h>\n#endif\n  .section .rodata\n")
  set(declarations "")
  set(entries "")
  set(number 0)
  foreach(file IN LISTS files)
    get_filename_component(file_name ${file} NAME)
    set(symbol axiometry_${namespace}_${name}_${number})
    string(APPEND assembly "  .global ${symbol}\n  .global ${symbol}_end\n  .balign 16\n${symbol}:\n  .incbin \"${file}\"\n${symbol}_end:\n  .byte 0\n")
    string(APPEND declarations "extern \"C\" const char ${symbol}[];\nextern \"C\" const char ${symbol}_end[];\n")
    string(APPEND entries "      {\"${file_name}\", {${symbol}, ${symbol}_end}},\n")
    math(EXPR number "${number} + 1")
  endforeach()
  string(APPEND assembly "  .section .note.GNU-stack,\"\",%progbits\n")
  set(stem ${PROJECT_BINARY_DIR}/generated/${namespace}_${name}_files)
  file(CONFIGURE OUTPUT ${stem}.S CONTENT "@assembly@" @ONLY)
  file(CONFIGURE OUTPUT ${stem}.cpp CONTENT
"// Generated by CMake.
#include \"axiometry/base/embedded_file.h\"

#include <array>
#include <span>

@declarations@
namespace axiometry::${namespace} {

std::span<const EmbeddedFile> ${name}_files() {
  static const std::array<EmbeddedFile, ${number}> files = {{
@entries@  }};
  return files;
}

}  // namespace axiometry::${namespace}
" @ONLY)
  set_source_files_properties(${stem}.S PROPERTIES OBJECT_DEPENDS "${files}")
  set_source_files_properties(${stem}.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  target_sources(${target} PRIVATE ${stem}.S ${stem}.cpp)
endfunction()
