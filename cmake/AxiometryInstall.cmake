# Installs axiometry::core and axiometry::axiometry as CMake packages, the headers, the program and
# its documents.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/axiometry)

install(TARGETS axiometry_core EXPORT axiometryCoreTargets)
install(EXPORT axiometryCoreTargets NAMESPACE axiometry:: DESTINATION ${package_dir})
install(DIRECTORY src/axiometry ${PROJECT_BINARY_DIR}/generated/axiometry DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.h" PATTERN "*_test_support.h" EXCLUDE PATTERN "test_support.h" EXCLUDE)
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
install(TARGETS axiometry_program)
install(DIRECTORY schema DESTINATION ${CMAKE_INSTALL_DATADIR}/axiometry)
install(PROGRAMS tools/verify_archive.py DESTINATION ${CMAKE_INSTALL_DATADIR}/axiometry)
install(FILES LICENSE licenses/components.json ${PROJECT_BINARY_DIR}/axiometry.spdx.json DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY licenses/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/licenses FILES_MATCHING PATTERN "*.txt")
install(FILES web/bundle/licenses.txt DESTINATION ${CMAKE_INSTALL_DOCDIR}/licenses RENAME page.txt)
install(DIRECTORY docs/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 FILES_MATCHING PATTERN "*.1")
