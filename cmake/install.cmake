# What `cmake --install` leaves: headers, libraries, the CMake package, pkg-config files, the command, its
# manual pages and its completion.
include(CMakePackageConfigHelpers)

set(parts batten)
if(BATTEN_PICTURE)
    list(APPEND parts batten-picture)
endif()
if(BATTEN_DESIGN)
    list(APPEND parts batten-design)
endif()

install(TARGETS ${parts} EXPORT batten-targets)
install(EXPORT batten-targets NAMESPACE batten:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/batten)
set(BATTEN_SHARED ${BUILD_SHARED_LIBS})
configure_package_config_file(cmake/batten-config.cmake.in ${PROJECT_BINARY_DIR}/batten-config.cmake
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/batten)
# Before 1.0 a program asks for the minor version it was written for.
set(compatibility SameMajorVersion)
if(PROJECT_VERSION_MAJOR EQUAL 0)
    set(compatibility SameMinorVersion)
endif()
write_basic_package_version_file(${PROJECT_BINARY_DIR}/batten-config-version.cmake COMPATIBILITY ${compatibility})
install(FILES ${PROJECT_BINARY_DIR}/batten-config.cmake ${PROJECT_BINARY_DIR}/batten-config-version.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/batten)

set(headers_of_picture picture.h)
set(headers_of_design design.h)
file(GLOB headers RELATIVE ${PROJECT_SOURCE_DIR}/include/batten CONFIGURE_DEPENDS include/batten/*.h)
if(NOT BATTEN_PICTURE)
    list(REMOVE_ITEM headers ${headers_of_picture})
endif()
if(NOT BATTEN_DESIGN)
    list(REMOVE_ITEM headers ${headers_of_design})
endif()
list(TRANSFORM headers PREPEND include/batten/)
install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/batten)

# The pkg-config files find their prefix from where they are, so that an installed tree may be moved.
file(RELATIVE_PATH to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
# What a library uses inside is for static linking alone; where there are no shared libraries, always.
function(batten_pkgconfig name description requires private private_links)
    set(links)
    if(NOT BUILD_SHARED_LIBS)
        string(APPEND requires " ${private}")
        set(links " ${private_links}")
        set(private)
        set(private_links)
    endif()
    configure_file(cmake/batten.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
batten_pkgconfig(batten "${PROJECT_DESCRIPTION}" "" "" "-lm ${CMAKE_THREAD_LIBS_INIT}")
if(BATTEN_PICTURE)
    batten_pkgconfig(batten-picture "Drawings and shaded pictures of Batten's shapes" "batten" "cairo" "-lm")
endif()
if(BATTEN_DESIGN)
    batten_pkgconfig(batten-design "Batten's design documents" "batten batten-picture" "yaml-0.1" "-lm")
endif()

# Manual pages of the main calls, from their doc blocks; where there is no Python, the headers say the same.
find_package(Python3 COMPONENTS Interpreter QUIET)
if(Python3_Interpreter_FOUND)
    set(stamp ${PROJECT_BINARY_DIR}/man3/.made)
    set(maker ${PROJECT_SOURCE_DIR}/docs/reference/man.py)
    file(GLOB all_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/batten/*.h)
    add_custom_command(OUTPUT ${stamp}
        COMMAND ${Python3_EXECUTABLE} ${maker} ${PROJECT_VERSION} ${PROJECT_BINARY_DIR}/man3
        COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
        DEPENDS ${maker} ${PROJECT_SOURCE_DIR}/docs/reference/main-calls.txt ${all_headers})
    add_custom_target(batten-man3 ALL DEPENDS ${stamp})
    install(DIRECTORY ${PROJECT_BINARY_DIR}/man3/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man3 FILES_MATCHING PATTERN "*.3")
endif()

if(TARGET batten-command)
    install(TARGETS batten-command)
    set(made ${PROJECT_BINARY_DIR}/cli)
    install(FILES ${made}/batten.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
    install(FILES ${made}/batten-design.5 DESTINATION ${CMAKE_INSTALL_MANDIR}/man5)
    install(FILES ${made}/batten.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME batten)
    install(FILES ${made}/design.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/batten)
endif()
