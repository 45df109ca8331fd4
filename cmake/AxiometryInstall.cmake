# Installs axiometry::core and axiometry::axiometry as packages of CMake and pkg-config, their public headers, the program
# and its documents.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/axiometry)

# axiometry_public_headers(VARIABLE LIBRARY): the headers below src/axiometry that cmake/public_headers.txt lists for it.
function(axiometry_public_headers output library)
  set(list_file ${PROJECT_SOURCE_DIR}/cmake/public_headers.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list_file})
  file(STRINGS ${list_file} lines REGEX "^[^#]")
  set(section "")
  set(headers "")
  foreach(line IN LISTS lines)
    if(line MATCHES "^(.*):$")
      set(section ${CMAKE_MATCH_1})
    elseif(section MATCHES "^${library} ")
      list(APPEND headers ${line})
    endif()
  endforeach()
  set(${output} "${headers}" PARENT_SCOPE)
endfunction()

function(axiometry_install_headers library)
  axiometry_public_headers(headers ${library})
  foreach(header IN LISTS headers)
    set(file ${PROJECT_SOURCE_DIR}/src/axiometry/${header})
    if(NOT EXISTS ${file})
      set(file ${PROJECT_BINARY_DIR}/generated/axiometry/${header})
    endif()
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${file} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/axiometry/${folder})
  endforeach()
endfunction()

# axiometry_pkg_config(NAME DESCRIPTION LIBRARY REQUIRED PRIVATE): NAME.pc. Who links a static library needs what it is
# made of as well, so that plain `pkg-config --libs` names that too.
function(axiometry_pkg_config AXIOMETRY_PC_NAME AXIOMETRY_PC_DESCRIPTION AXIOMETRY_PC_LIBRARY required private)
  set(AXIOMETRY_PC_REQUIRES "${required}")
  set(AXIOMETRY_PC_REQUIRES_PRIVATE "${private}")
  if(NOT BUILD_SHARED_LIBS)
    string(STRIP "${required} ${private}" AXIOMETRY_PC_REQUIRES)
    set(AXIOMETRY_PC_REQUIRES_PRIVATE "")
  endif()
  set(folder ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
  file(RELATIVE_PATH AXIOMETRY_PC_PREFIX ${folder} ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" AXIOMETRY_PC_PREFIX "${AXIOMETRY_PC_PREFIX}")
  file(RELATIVE_PATH AXIOMETRY_PC_LIBDIR ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
  file(RELATIVE_PATH AXIOMETRY_PC_INCLUDEDIR ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
  set(file ${PROJECT_BINARY_DIR}/${AXIOMETRY_PC_NAME}.pc)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/axiometry.pc.in ${file} @ONLY)
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

install(TARGETS axiometry_core EXPORT axiometryCoreTargets)
install(EXPORT axiometryCoreTargets NAMESPACE axiometry:: DESTINATION ${package_dir})
axiometry_install_headers(core)
axiometry_pkg_config(axiometry-core "The mathematics of ISO 230-2: parameters, uncertainty, verdicts, plans, tracking"
                     axiometry_core "" "fmt")
configure_package_config_file(cmake/axiometryConfig.cmake.in ${PROJECT_BINARY_DIR}/axiometryConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/axiometryConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/axiometryConfig.cmake ${PROJECT_BINARY_DIR}/axiometryConfigVersion.cmake
        DESTINATION ${package_dir})

if(AXIOMETRY_CORE_ONLY)
  return()
endif()

install(TARGETS axiometry EXPORT axiometryTargets)
install(EXPORT axiometryTargets NAMESPACE axiometry:: DESTINATION ${package_dir})
axiometry_install_headers(axiometry)
axiometry_pkg_config(axiometry "Formats, reports and use cases of positioning tests after ISO 230-2" axiometry
                     "axiometry-core = ${PROJECT_VERSION}" "libcrypto pangocairo muparser sqlite3 libpq")
if(BUILD_SHARED_LIBS) # the installed program finds them beside itself, wherever both lie
  file(RELATIVE_PATH libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(axiometry_program PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries}")
  set_target_properties(axiometry PROPERTIES INSTALL_RPATH "$ORIGIN")
endif()
install(TARGETS axiometry_program)
install(DIRECTORY schema DESTINATION ${CMAKE_INSTALL_DATADIR}/axiometry)
install(PROGRAMS tools/verify_archive.py DESTINATION ${CMAKE_INSTALL_DATADIR}/axiometry)
install(FILES LICENSE licenses/components.json ${PROJECT_BINARY_DIR}/axiometry.spdx.json DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY licenses/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/licenses FILES_MATCHING PATTERN "*.txt")
install(FILES web/bundle/licenses.txt DESTINATION ${CMAKE_INSTALL_DOCDIR}/licenses RENAME page.txt)
install(DIRECTORY docs/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 FILES_MATCHING PATTERN "*.1")
